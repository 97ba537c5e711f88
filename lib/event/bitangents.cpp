// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/bitangents.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "event/contacts.hpp"
#include "event/surroundings.hpp"
#include "sightline/geom/predicates2.hpp"

namespace sightline {
namespace detail {
namespace {

// All pairs of vertices at which some line is tangent; from each of them to those that are greater.
class BitangentSearch {
public:
    BitangentSearch(const Scene2& scene, const Limits& limits)
        : scene_(scene), limits_(limits), around_(scene), contacts_(scene) {
        seen_.assign(contacts_.owner_count(), {});
    }

    /// Of these owners only; `one_body`: also between contacts of one owner.
    template <typename Wanted>
    [[nodiscard]] std::optional<Error> run(const Wanted& wanted, bool one_body) {
        one_body_ = one_body;
        for (std::uint32_t i = 0; i < scene_.vertex_count(); ++i) {
            const VertexId v{i};
            if (around_.has_tangents(v) && wanted(contacts_.owner(v))) candidates_.push_back(v);
        }
        std::sort(candidates_.begin(), candidates_.end(), [&](VertexId a, VertexId b) {
            return scene_[a] < scene_[b] || (scene_[a] == scene_[b] && a < b);
        });
        for (std::size_t i = 0; i < candidates_.size(); ++i) {
            look_from(i);
            if (auto error = check(i)) return error;
        }
        std::sort(found_.begin(), found_.end());
        return std::nullopt;
    }

    [[nodiscard]] std::vector<Bitangent> take() { return std::move(found_); }

private:
    void look_from(std::size_t i) {
        const VertexId v = candidates_[i];
        const Point2& place = scene_[v];
        partners_.clear();
        for (std::size_t j = i + 1; j < candidates_.size(); ++j) {
            const VertexId w = candidates_[j];
            if (around_.is_tangent(scene_[w], v) && scene_[w] != place &&
                around_.is_tangent(place, w))
                partners_.push_back(w);
        }
        // Lines through v in the order of their directions, along each of them the nearest first.
        std::sort(partners_.begin(), partners_.end(), [&](VertexId a, VertexId b) {
            const Sign turn = orientation(place, scene_[a], scene_[b]);
            if (turn != Sign::zero) return turn == Sign::positive;
            return scene_[a] < scene_[b] || (scene_[a] == scene_[b] && a < b);
        });
        for (std::size_t k = 0; k < partners_.size();) k = keep_nearest(v, k);
    }

    // Of the partners of v on one line, from number k on: those with no contact of the two owners
    // before them. Returns the number after them.
    std::size_t keep_nearest(VertexId v, std::size_t k) {
        const Point2& place = scene_[v];
        const Point2& first = scene_[partners_[k]];
        ++line_;
        const std::uint32_t own = contacts_.owner(v);
        for (; k < partners_.size(); ++k) {
            const VertexId w = partners_[k];
            if (orientation(place, first, scene_[w]) != Sign::zero) break;
            const std::uint32_t other = contacts_.owner(w);
            const auto is_beyond = [&](std::uint32_t owner) {
                const Seen& seen = seen_[owner];
                return seen.line == line_ && scene_[seen.vertex] != scene_[w];
            };
            if (!is_beyond(own) && !is_beyond(other) && (one_body_ || own != other)) {
                const Bitangent b = contacts_.bitangent(v, w);
                found_.push_back(b);
                found_.push_back(reversed(b));
            }
            if (seen_[other].line != line_) seen_[other] = {line_, w};
        }
        return k;
    }

    std::optional<Error> check(std::size_t i) {
        if (found_.size() > limits_.max_elements)
            return Error{Errc::limit_reached, "there are more than " +
                                                  std::to_string(limits_.max_elements) +
                                                  " bitangents; raise the limit"};
        if ((i + 1) % 64 != 0) return std::nullopt;
        if (limits_.stop && limits_.stop())
            return Error{Errc::cancelled, "stopped: " + std::to_string(i + 1) + " of " +
                                              std::to_string(candidates_.size()) +
                                              " vertices done, " + std::to_string(found_.size()) +
                                              " bitangents found"};
        if (limits_.progress)
            limits_.progress(static_cast<double>(i + 1) / static_cast<double>(candidates_.size()));
        return std::nullopt;
    }

    /// The nearest contact of an owner on the line at hand.
    struct Seen {
        std::uint64_t line = 0;
        VertexId vertex;
    };

    const Scene2& scene_;
    const Limits& limits_;
    Surroundings around_;
    Contacts contacts_;
    bool one_body_ = false;
    std::vector<VertexId> candidates_;  // ascending by place
    std::vector<VertexId> partners_;
    std::uint64_t line_ = 0;
    std::vector<Seen> seen_;  // an owner
    std::vector<Bitangent> found_;
};

}  // namespace
}  // namespace detail

Result<std::vector<Bitangent>> bitangents(const Scene2& scene, const BitangentOptions& options,
                                          const Limits& limits) {
    detail::BitangentSearch search(scene, limits);
    const auto all = [](std::uint32_t) { return true; };
    if (auto error = search.run(all, options.one_body)) return tl::unexpected<Error>(*error);
    return search.take();
}

std::vector<Bitangent> bitangents(const Scene2& scene, const BitangentOptions& options) {
    return *bitangents(scene, options, Limits{});
}

std::vector<Bitangent> bitangents(const Scene2& scene, BodyId a, BodyId b) {
    SIGHTLINE_EXPECT(a.index() < scene.body_count() && b.index() < scene.body_count());
    const Limits limits;
    detail::BitangentSearch search(scene, limits);
    const auto wanted = [&](std::uint32_t owner) { return owner == a.value || owner == b.value; };
    const auto error = search.run(wanted, a == b);
    SIGHTLINE_EXPECT(!error);
    return search.take();
}

std::vector<SupportingLine2> supporting_lines(const Scene2& scene, BodyId body,
                                              const Point2& point) {
    SIGHTLINE_EXPECT(body.index() < scene.body_count());
    SIGHTLINE_EXPECT(std::isfinite(point.x) && std::isfinite(point.y));
    const detail::Surroundings around(scene);
    const detail::Contacts contacts(scene);
    std::vector<VertexId> found;
    for (std::uint32_t i = 0; i < scene.vertex_count(); ++i) {
        const VertexId v{i};
        if (contacts.is_of_area(v) && contacts.body(v) == body && scene[v] != point &&
            around.is_tangent(point, v))
            found.push_back(v);
    }
    // By direction, along each ray the nearest first: with the rays that go up the plane's
    // lexicographic order before those that go down.
    std::sort(found.begin(), found.end(), [&](VertexId a, VertexId b) {
        const bool up = point < scene[a];
        if (up != (point < scene[b])) return up;
        const Sign turn = orientation(point, scene[a], scene[b]);
        if (turn != Sign::zero) return turn == Sign::positive;
        return up ? scene[a] < scene[b] : scene[b] < scene[a];
    });
    std::vector<SupportingLine2> lines;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Point2& place = scene[found[i]];
        std::size_t nearest = i;
        while (nearest > 0 && (point < scene[found[nearest - 1]]) == (point < place) &&
               orientation(point, scene[found[nearest - 1]], place) == Sign::zero)
            --nearest;
        if (scene[found[nearest]] != place) continue;
        lines.push_back({found[i], body, contacts.side(point, place, found[i]), point});
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

}  // namespace sightline
