// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/event/catalogue.hpp"

#include <algorithm>
#include <ostream>
#include <tuple>

namespace sightline {
namespace {

RationalPoint3 place(VertexId v, const Scene3& scene) { return to_rational(scene[v]); }

struct Writer {
    std::ostream& out;

    void operator()(const Fv& e) const {
        out << ' ' << to_string(e.face) << ' ' << to_string(e.vertex);
    }
    void operator()(const EV& e) const {
        out << ' ' << to_string(e.edge) << ' ' << to_string(e.vertex);
    }
    void operator()(const FE& e) const {
        out << ' ' << to_string(e.face) << ' ' << to_string(e.edge);
    }
    void operator()(const EEE& e) const {
        for (const EdgeId edge : e.edges) out << ' ' << to_string(edge);
    }
};

struct Sweeper {
    const Scene3& scene;

    std::vector<Swath> operator()(const Fv& e) const {
        const Plane3 plane = plane_of(e.face, scene);
        const RationalPoint3 v = place(e.vertex, scene);
        if (plane.height(v).sign() != Sign::zero) return {};
        return {Swath::pencil({vector_to(v), 1}, plane)};
    }
    std::vector<Swath> operator()(const EV& e) const {
        return families_meeting({place(e.vertex, scene)}, {carrier(e.edge, scene)}).swaths;
    }
    std::vector<Swath> operator()(const FE& e) const {
        const Plane3 plane = plane_of(e.face, scene);
        const ProjectivePoint3 p = meeting_point(carrier(e.edge, scene), plane);
        if (!p.is_finite()) return {};
        return {Swath::pencil(p, plane)};
    }
    std::vector<Swath> operator()(const EEE& e) const {
        std::vector<RationalLine3> lines;
        for (const EdgeId edge : e.edges) lines.push_back(carrier(edge, scene));
        LineFamilies all = families_meeting({}, lines);
        if (all.has_larger) return {};
        return std::move(all.swaths);
    }
};

/// Tells which of some features a family keeps.
class Describer {
public:
    Describer(std::vector<VertexId> vertices, std::vector<EdgeId> edges, const Scene3& scene)
        : scene_(scene), vertices_(std::move(vertices)), edges_(std::move(edges)) {
        std::ranges::sort(edges_);
        edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
        for (const EdgeId e : edges_) carriers_.push_back(carrier(e, scene));
    }

    [[nodiscard]] const std::vector<VertexId>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<RationalLine3>& carriers() const { return carriers_; }

    [[nodiscard]] EventFamily operator()(const Swath& swath) const {
        EventFamily family{EventKind::eee, swath, {}, {}, {}};
        for (const VertexId v : vertices_) {
            if (swath.all_pass(place(v, scene_))) family.vertices.push_back(v);
        }
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool is_through = std::ranges::any_of(
                family.vertices, [&](VertexId v) { return is_on(carriers_[i], place(v, scene_)); });
            if (!is_through && swath.all_meet(carriers_[i])) family.edges.push_back(edges_[i]);
        }
        family.faces = faces_of(family);
        if (family.vertices.empty()) {
            family.kind = family.faces.empty() ? EventKind::eee : EventKind::fe;
        } else {
            family.kind = family.faces.empty() ? EventKind::ev : EventKind::fv;
        }
        return family;
    }

private:
    /// Faces with a vertex or two edges among those kept, in whose planes the family lies.
    [[nodiscard]] std::vector<FaceId> faces_of(const EventFamily& family) const {
        std::vector<FaceId> candidates;
        const auto add_faces = [&](EdgeId e, std::size_t times) {
            for (const FaceId f : scene_[e].faces) {
                if (!f.is_none()) candidates.insert(candidates.end(), times, f);
            }
        };
        for (const VertexId v : family.vertices) {
            for (const EdgeId e : scene_.edges_at(v)) add_faces(e, 2);
        }
        for (const EdgeId e : family.edges) add_faces(e, 1);
        std::ranges::sort(candidates);
        std::vector<FaceId> faces;
        for (std::size_t i = 0; i + 1 < candidates.size(); ++i) {
            const FaceId f = candidates[i];
            if (f != candidates[i + 1] || (!faces.empty() && faces.back() == f)) continue;
            if (family.swath.all_in(plane_of(f, scene_))) faces.push_back(f);
        }
        return faces;
    }

    const Scene3& scene_;
    std::vector<VertexId> vertices_;
    std::vector<EdgeId> edges_;
    std::vector<RationalLine3> carriers_;
};

/// The edges that a line with this support meets now, and those that it may meet when it leaves a vertex.
std::vector<EdgeId> edges_near(const Support& support, const Scene3& scene) {
    std::vector<EdgeId> edges = support.edges;
    edges.insert(edges.end(), support.along.begin(), support.along.end());
    for (const VertexId v : support.vertices) {
        const auto at = scene.edges_at(v);
        edges.insert(edges.end(), at.begin(), at.end());
    }
    return edges;
}

void sort_families(std::vector<EventFamily>& families) {
    std::ranges::sort(families, {}, [](const EventFamily& f) {
        return std::tie(f.kind, f.vertices, f.edges, f.faces);
    });
}

/// Collects the families through one critical line.
class FamilyFinder {
public:
    FamilyFinder(const SurdLine3& line, const Describer& describe, const Scene3& scene)
        : line_(line), describe_(describe), scene_(scene) {}

    std::vector<EventFamily> find() {
        const auto& carriers = describe_.carriers();
        for (const VertexId v : describe_.vertices()) {
            for (const RationalLine3& l : carriers) add({place(v, scene_)}, {l});
        }
        for (std::size_t i = 0; i < carriers.size(); ++i) {
            for (std::size_t j = i + 1; j < carriers.size(); ++j) {
                for (std::size_t k = j + 1; k < carriers.size(); ++k) {
                    add({}, {carriers[i], carriers[j], carriers[k]});
                }
            }
        }
        sort_families(found_);
        return std::move(found_);
    }

private:
    void add(const std::vector<RationalPoint3>& points, const std::vector<RationalLine3>& lines) {
        for (const Swath& swath : families_meeting(points, lines).swaths) {
            const bool is_known =
                std::ranges::any_of(found_, [&](const EventFamily& f) { return f.swath == swath; });
            if (!is_known && swath.contains(line_)) found_.push_back(describe_(swath));
        }
    }

    const SurdLine3& line_;
    const Describer& describe_;
    const Scene3& scene_;
    std::vector<EventFamily> found_;
};

}  // namespace

std::string_view name_of(EventKind kind) noexcept {
    constexpr std::array names{"Fv", "EV", "FE", "EEE"};
    return names[static_cast<std::size_t>(kind)];
}

EventKind kind_of(const VisualEvent& event) noexcept {
    return static_cast<EventKind>(event.index());
}

std::ostream& operator<<(std::ostream& out, const VisualEvent& event) {
    out << name_of(kind_of(event));
    std::visit(Writer{out}, event);
    return out;
}

std::vector<Swath> swaths_of(const VisualEvent& event, const Scene3& scene) {
    return std::visit(Sweeper{scene}, event);
}

std::vector<EventFamily> families_at(const SurdLine3& line, const Support& support,
                                     const Scene3& scene) {
    const Describer describe(support.vertices, edges_near(support, scene), scene);
    return FamilyFinder(line, describe, scene).find();
}

std::vector<EventFamily> families_keeping(const Support& support, const Scene3& scene) {
    const Describer describe(support.vertices, support.edges, scene);
    std::vector<EventFamily> families;
    for (const Swath& swath : families_of(support, scene).swaths) {
        families.push_back(describe(swath));
    }
    sort_families(families);
    return families;
}

}  // namespace sightline
