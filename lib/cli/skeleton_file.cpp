// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/skeleton_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <sstream>
#include <stdexcept>

namespace sightline::detail {
namespace {

using Json = nlohmann::json;

/// Names something that the scene does not have.
struct Unknown : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Turns what the document says into ids of the scene.
class Reader {
public:
    explicit Reader(const Scene3& scene) : scene_(scene) {
        for (std::uint32_t e = 0; e < scene.edges().size(); ++e) {
            const Edge3& edge = scene[EdgeId{e}];
            edges_.emplace(std::pair{edge.source.value, edge.target.value}, EdgeId{e});
        }
        for (std::uint32_t f = 0; f < scene.faces().size(); ++f) {
            faces_.emplace(scene[FaceId{f}].input_faces.front(), FaceId{f});
        }
    }

    SkeletonNode node(const Json& json) const {
        SkeletonNode node;
        node.type = type<NodeType>(json, 6);
        node.label = label(json);
        for (const Json& e : json.at("along")) node.label.support.along.push_back(edge(e));
        for (const Json& f : json.at("faces")) node.faces.push_back(face(f));
        const Json& root = json.at("root");
        if (!root.is_null()) node.root = root.get<int>() == 0 ? Root::first : Root::second;
        return node;
    }
    SkeletonArc arc(const Json& json, std::size_t nodes) const {
        SkeletonArc arc;
        arc.type = type<ArcType>(json, 4);
        arc.label = label(json);
        for (std::size_t i = 0; i < 2; ++i) {
            arc.nodes[i] = NodeId{json.at("nodes").at(i).get<std::uint32_t>()};
            if (arc.nodes[i].index() >= nodes) throw Unknown("a node that is not in the list");
        }
        return arc;
    }

private:
    template <typename Type>
    static Type type(const Json& json, int count) {
        const auto name = json.at("type").get<std::string>();
        for (int i = 0; i < count; ++i) {
            if (name_of(static_cast<Type>(i)) == name) return static_cast<Type>(i);
        }
        throw Unknown("the type '" + name + "'");
    }
    SegmentLabel label(const Json& json) const {
        SegmentLabel label;
        const Json& support = json.at("support");
        for (const Json& v : support.at("vertices")) {
            const VertexId id{v.get<std::uint32_t>()};
            if (id.index() >= scene_.vertices().size()) throw Unknown("vertex " + v.dump());
            label.support.vertices.push_back(id);
        }
        for (const Json& e : support.at("edges")) label.support.edges.push_back(edge(e));
        for (std::size_t i = 0; i < 2; ++i) label.ends[i] = end(json.at("ends").at(i));
        return label;
    }
    EdgeId edge(const Json& json) const {
        const auto found =
            edges_.find({json.at(0).get<std::uint32_t>(), json.at(1).get<std::uint32_t>()});
        if (found == edges_.end()) throw Unknown("edge " + json.dump());
        return found->second;
    }
    FaceId face(const Json& json) const {
        const auto found = faces_.find(json.get<std::uint32_t>());
        if (found == faces_.end()) throw Unknown("face " + json.dump());
        return found->second;
    }
    SegmentEnd end(const Json& json) const {
        SegmentEnd end;
        if (json.is_null()) return end;
        for (const Json& side : json) {
            const bool back = side.is_object();
            end.push_back({face(back ? side.at("back") : side), back});
        }
        return end;
    }

    const Scene3& scene_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, EdgeId> edges_;
    std::map<std::uint32_t, FaceId> faces_;
};

}  // namespace

Result<VisibilitySkeleton> skeleton_of(const Json& result, const Scene3& scene,
                                       const std::string& path) {
    try {
        const Reader read(scene);
        std::vector<SkeletonNode> nodes;
        std::vector<SkeletonArc> arcs;
        for (const Json& node : result.at("nodes")) nodes.push_back(read.node(node));
        for (const Json& arc : result.at("arcs")) arcs.push_back(read.arc(arc, nodes.size()));
        return VisibilitySkeleton(std::move(nodes), std::move(arcs));
    } catch (const Unknown& problem) {
        return fail(Errc::bad_parameter,
                    fmt::format("{}: names {}, which this scene does not have; name the files that "
                                "it was made from",
                                path, problem.what()));
    } catch (const Json::exception&) {
        return fail(Errc::syntax, path + ": is no skeleton as sightline writes it; write it again");
    }
}

Result<void> choose_arcs(const std::string& text, const VisibilitySkeleton& skeleton,
                         viz::SkeletonDrawOptions& options) {
    if (text.empty()) return {};
    std::vector<ArcId> chosen;
    std::istringstream words(text);
    for (std::string word; std::getline(words, word, ',');) {
        std::uint32_t number = 0;
        const auto [rest, problem] =
            std::from_chars(word.data(), word.data() + word.size(), number);
        const bool is_number = problem == std::errc{} && rest == word.data() + word.size();
        bool found = is_number && number < skeleton.arcs().size();
        if (found) chosen.push_back(ArcId{number});
        for (const ArcType type : {ArcType::fv, ArcType::ev, ArcType::fe, ArcType::eee}) {
            if (name_of(type) != word) continue;
            found = true;
            for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
                if (skeleton[ArcId{a}].type == type) chosen.push_back(ArcId{a});
            }
        }
        if (!found) {
            return fail(Errc::bad_parameter,
                        fmt::format("--arcs: '{}' is neither EV, EEE, Fv or FE nor the number of "
                                    "one of the {} arcs; write a list, as in EEE or 12,40",
                                    word, skeleton.arcs().size()));
        }
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    options.arcs = std::move(chosen);
    return {};
}

}  // namespace sightline::detail
