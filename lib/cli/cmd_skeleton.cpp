// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iostream>
#include <memory>

#include "cli/document.hpp"
#include "cli/program.hpp"
#include "cli/skeleton_json.hpp"
#include "sightline/skeleton/build.hpp"
#include "sightline/skeleton/check.hpp"
#include "sightline/viz/draw_skeleton.hpp"

namespace sightline::detail {
namespace {

struct SkeletonArguments {
    SceneArguments scene;
    OutputArguments outputs;
    std::string arcs_only;
    std::string pair;
    bool check = false;
    SkeletonCheckOptions checking;
};

constexpr std::array arc_types{ArcType::fv, ArcType::ev, ArcType::fe, ArcType::eee};

std::optional<ArcType> only_type(const SkeletonArguments& arguments) {
    const auto* const type = std::ranges::find(arc_types, arguments.arcs_only,
                                               [](ArcType t) { return std::string(name_of(t)); });
    return type == arc_types.end() ? std::nullopt : std::optional(*type);
}

/// "12,7"
std::optional<std::array<std::uint32_t, 2>> two_numbers(const std::string& text) {
    std::array<std::uint32_t, 2> numbers{};
    const char* const end = text.data() + text.size();
    const auto first = std::from_chars(text.data(), end, numbers[0]);
    if (first.ec != std::errc{} || first.ptr == end || *first.ptr != ',') return std::nullopt;
    const auto second = std::from_chars(first.ptr + 1, end, numbers[1]);
    if (second.ec != std::errc{} || second.ptr != end) return std::nullopt;
    return numbers;
}

Result<std::array<FaceId, 2>> faces_of(const std::string& text, const Scene3& scene) {
    const auto numbers = two_numbers(text);
    if (!numbers) {
        return fail(
            Errc::bad_parameter,
            fmt::format("--pair: '{}' are no two faces; write F,G with the numbers of faces "
                        "in the files, as in 0,7",
                        text));
    }
    std::array<FaceId, 2> faces;
    for (std::size_t i = 0; i < 2; ++i) {
        const auto face = std::ranges::find_if(scene.faces(), [&](const Face3& f) {
            return std::ranges::binary_search(f.input_faces, (*numbers)[i]);
        });
        if (face == scene.faces().end()) {
            return fail(Errc::bad_parameter,
                        fmt::format("--pair: there is no face {}; `sightline info` tells how many "
                                    "there are",
                                    (*numbers)[i]));
        }
        faces[i] = FaceId{static_cast<std::uint32_t>(face - scene.faces().begin())};
    }
    return faces;
}

Result<SkeletonPart> part_of(const SkeletonArguments& arguments, const Scene3& scene) {
    SkeletonPart part;
    if (!arguments.pair.empty()) {
        const auto faces = faces_of(arguments.pair, scene);
        if (!faces) return tl::unexpected(faces.error());
        part.between = *faces;
    }
    return part;
}

nlohmann::ordered_json options_of(const SkeletonArguments& arguments, const Session& session) {
    nlohmann::ordered_json options;
    options["arithmetic"] = name_of(session.common().arithmetic);
    if (!arguments.arcs_only.empty()) options["arcs_only"] = arguments.arcs_only;
    if (!arguments.pair.empty()) options["pair"] = arguments.pair;
    return options;
}

Result<VisibilitySkeleton> build(const Scene3& scene, const SkeletonPart& part, Session& session) {
    SkeletonOptions options;
    options.arithmetic = session.common().arithmetic;
    options.tally = &session.tally();
    options.threads = session.common().threads;
    options.part = part;
    return session.timed("build", "building the skeleton",
                         [&] { return visibility_skeleton(scene, options, session.limits()); });
}

/// "12 nodes (VV 6, EEEE 6), 20 arcs (EV 20)"
std::string summary_of(const VisibilitySkeleton& skeleton) {
    const auto kinds = [](const auto& cells) {
        std::vector<std::size_t> counts;
        for (const auto& cell : cells) {
            const auto type = static_cast<std::size_t>(cell.type);
            counts.resize(std::max(counts.size(), type + 1));
            ++counts[type];
        }
        std::string text;
        using Type = decltype(cells.front().type);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (counts[i] == 0) continue;
            text += fmt::format("{}{} {}", text.empty() ? " (" : ", ",
                                name_of(static_cast<Type>(i)), counts[i]);
        }
        return text.empty() ? text : text + ")";
    };
    return fmt::format("{} nodes{}, {} arcs{}", skeleton.nodes().size(), kinds(skeleton.nodes()),
                       skeleton.arcs().size(), kinds(skeleton.arcs()));
}

viz::DrawList picture_of(const Scene3& scene, const VisibilitySkeleton& skeleton,
                         std::optional<ArcType> only) {
    viz::SkeletonDrawOptions options;
    if (only) {
        options.arcs.emplace();
        for (std::uint32_t a = 0; a < skeleton.arcs().size(); ++a) {
            if (skeleton[ArcId{a}].type == *only) options.arcs->push_back(ArcId{a});
        }
    }
    return viz::draw(scene, skeleton, options);
}

/// Says on standard output what the check found.
Result<ExitStatus> check(const Scene3& scene, const VisibilitySkeleton& skeleton,
                         const SkeletonArguments& arguments, Session& session) {
    const auto found = session.timed("check", "checking the skeleton", [&] {
        return check_skeleton(scene, skeleton, arguments.checking, session.limits());
    });
    if (!found) return tl::unexpected(found.error());
    for (const std::string& mismatch : found->mismatches) std::cout << mismatch << '\n';
    std::cout << "check: " << *found << '\n';
    return found->passes() ? ExitStatus::done : ExitStatus::no_answer;
}

Result<ExitStatus> run_skeleton(const SkeletonArguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    if (arguments.check && !arguments.pair.empty()) {
        return fail(Errc::bad_parameter, "--check needs the whole skeleton; leave out --pair");
    }
    const Result<LoadedScene3> loaded = load_scene3(arguments.scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    const Scene3& scene = loaded->scene;
    const auto part = part_of(arguments, scene);
    if (!part) return tl::unexpected(part.error());
    const Result<VisibilitySkeleton> skeleton = build(scene, *part, session);
    if (!skeleton) return tl::unexpected(skeleton.error());
    ExitStatus status = ExitStatus::done;
    if (arguments.check) {
        const auto checked = check(scene, *skeleton, arguments, session);
        if (!checked) return tl::unexpected(checked.error());
        status = *checked;
    }
    if (!arguments.check || !arguments.outputs.given().empty()) {
        Document document;
        document.kind = "visibility_skeleton";
        document.scene3 = &*loaded;
        document.options = options_of(arguments, session);
        document.result = [&](JsonWriter& json) {
            write_skeleton(json, scene, *skeleton, only_type(arguments));
        };
        document.picture = [&] { return picture_of(scene, *skeleton, only_type(arguments)); };
        const auto written = write_outputs(arguments.outputs, document, session);
        if (!written) return tl::unexpected(written.error());
    }
    session.note("skeleton: " + summary_of(*skeleton));
    return status;
}

}  // namespace

void add_skeleton(Program& program) {
    const auto arguments = std::make_shared<SkeletonArguments>();
    CLI::App& app =
        program.add("skeleton", "3D visibility skeleton",
                    "sightline skeleton boxes.off triangle.off -o skeleton.json --vtk skeleton.vtm",
                    [arguments](Session& session) { return run_skeleton(*arguments, session); });
    add_mesh_arguments(app, arguments->scene);
    app.add_option("--pair", arguments->pair,
                   "only arcs that end at both faces, by their numbers in the files")
        ->type_name("F,G");
    app.add_option("--arcs-only", arguments->arcs_only,
                   "write only arcs of this type: Fv, EV, FE or EEE")
        ->check(CLI::IsMember({"Fv", "EV", "FE", "EEE"}))
        ->type_name("TYPE");
    app.add_flag("--check", arguments->check,
                 "compare the skeleton with shots along random paths of lines; exit status 1 when "
                 "an arc is missing or false");
    app.add_option("--check-paths", arguments->checking.families, "how many paths (200)")
        ->check(CLI::Range(1, 100'000'000))
        ->type_name("N");
    app.add_option("--seed", arguments->checking.seed, "of the paths (1)")->type_name("S");
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
