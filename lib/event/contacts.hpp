// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sightline/event/bitangent.hpp"
#include "sightline/scene/scene2.hpp"

namespace sightline::detail {

/// What lines touch at the vertices of a scene: each vertex with its own edges.
class Contacts {
public:
    explicit Contacts(const Scene2& scene);

    [[nodiscard]] BodyId body(VertexId v) const { return at_[v].body; }
    /// Whether v lies on the boundary of a body or of the world.
    [[nodiscard]] bool is_of_area(VertexId v) const { return at_[v].of_area; }
    /// A number that the vertices of one body share, and those of the world; a vertex of a wall and
    /// a point have their own.
    [[nodiscard]] std::uint32_t owner(VertexId v) const;
    [[nodiscard]] std::size_t owner_count() const { return scene_->body_count() + 1 + at_.size(); }

    /// The side of v's edges, seen along the line through v from `from` to `to`, one of which may
    /// be v. Exact.
    [[nodiscard]] Side side(const Point2& from, const Point2& to, VertexId v) const;
    /// The bitangent from v to w, if it is one.
    [[nodiscard]] Bitangent bitangent(VertexId v, VertexId w) const;

private:
    struct Contact {
        VertexId previous;
        VertexId next;
        BodyId body;
        bool of_area = false;
    };
    const Scene2* scene_;
    PerVertex<Contact> at_;
};

}  // namespace sightline::detail
