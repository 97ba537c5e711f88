// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/document.hpp"

#include <fmt/format.h>

#include <chrono>
#include <filesystem>

#include "cli/output_set.hpp"
#include "sightline/viz/render.hpp"
#include "sightline/viz/svg.hpp"
#include "sightline/viz/vtk_file.hpp"

namespace sightline::detail {
namespace {

using Layout = JsonWriter::Layout;
using Clock = std::chrono::steady_clock;

constexpr std::size_t seconds_width = 10;

std::string seconds_text(double seconds) {
    return fmt::format("{:<{}}", fmt::format("{:.6f}", seconds), seconds_width);
}

void write_scene(JsonWriter& json, const SceneArguments& arguments, std::size_t vertices,
                 std::size_t bodies) {
    std::vector<std::string> files = arguments.files;
    files.insert(files.end(), arguments.sheet_files.begin(), arguments.sheet_files.end());
    json.key("scene");
    json.begin_object(Layout::inline_);
    json.key("files");
    json.tree(files);
    json.member("vertices", vertices);
    json.member("bodies", bodies);
    json.end();
}

const SceneArguments* arguments_of(const Document& document) {
    if (document.scene != nullptr) return &document.scene->arguments;
    return document.scene3 != nullptr ? &document.scene3->arguments : nullptr;
}

void write_options(JsonWriter& json, const Document& document) {
    nlohmann::ordered_json options = document.options;
    if (const SceneArguments* scene = arguments_of(document)) {
        if (scene->world) options["world"] = true;
        if (scene->repair) options["repair"] = true;
        if (scene->all_lines) options["all_lines"] = true;
        if (scene->sheets) options["sheets"] = true;
        if (!scene->sheet_files.empty()) options["sheet"] = scene->sheet_files;
    }
    json.key("options");
    json.tree(options);
}

void write_predicates(JsonWriter& json, const Tally& tally) {
    json.key("predicates");
    json.begin_object();
    for (int i = 0; i < static_cast<int>(Predicate::count_); ++i) {
        const auto predicate = static_cast<Predicate>(i);
        const TierCounts& counts = tally[predicate];
        if (counts.calls == 0) continue;
        json.key(name_of(predicate));
        json.begin_object(Layout::inline_);
        json.member("calls", counts.calls);
        json.member("filter", counts.filter);
        json.member("interval", counts.interval);
        json.member("exact", counts.exact);
        json.member("undecided", counts.undecided);
        json.end();
    }
    json.end();
}

/// Returns where the time of writing is to be filled in.
std::uint64_t write_stats(JsonWriter& json, const Session& session) {
    json.key("stats");
    json.begin_object();
    json.key("seconds");
    json.begin_object(Layout::inline_);
    for (const auto& [name, seconds] : session.seconds()) {
        json.key(name);
        json.raw(fmt::format("{:.6f}", seconds));
    }
    json.key("write");
    const std::uint64_t place = json.position();
    json.raw(seconds_text(0));
    json.end();
    json.member("peak_memory_bytes", peak_memory_bytes());
    write_predicates(json, session.tally());
    json.end();
    return place;
}

std::uint64_t write_document(std::ostream& out, const Document& document, const Session& session) {
    JsonWriter json(out);
    json.begin_object();
    json.key("sightline");
    json.tree({{"version", SIGHTLINE_VERSION}, {"format", 1}});
    json.member("kind", document.kind);
    if (const LoadedScene* plane = document.scene) {
        write_scene(json, plane->arguments, plane->scene.vertex_count(), plane->scene.body_count());
    } else if (const LoadedScene3* space = document.scene3) {
        write_scene(json, space->arguments, space->scene.vertices().size(),
                    space->scene.bodies().size());
    } else if (!document.inputs.is_null()) {
        json.key("scene");
        json.tree(document.inputs);
    }
    write_options(json, document);
    const std::uint64_t place = write_stats(json, session);
    if (!document.complete) json.member("complete", false);
    json.key("result");
    document.result(json);
    json.end();
    return place;
}

Result<void> write_json(OutputSet& files, const std::string& path, const Document& document,
                        const Session& session, Clock::time_point start) {
    std::uint64_t place = 0;
    return files.write(
        path, [&](std::ostream& out) { place = write_document(out, document, session); },
        [&](std::ostream& out) {
            out.flush();
            out.seekp(static_cast<std::streamoff>(place));
            out << seconds_text(std::chrono::duration<double>(Clock::now() - start).count());
        });
}

/// The index, and beside it a file for each layer.
Result<void> write_vtm(OutputSet& files, const std::string& path, const viz::DrawList& picture) {
    const std::filesystem::path file(path);
    const std::string stem = file.stem().string();
    const std::vector<std::string> parts = viz::vtm_parts(picture, stem);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const auto done =
            files.write((file.parent_path() / parts[i]).string(),
                        [&](std::ostream& out) { viz::write_vtm_part(picture, i, out); });
        if (!done) return done;
    }
    return files.write(path, [&](std::ostream& out) { viz::write_vtm(picture, stem, out); });
}

Result<void> write_vtk(OutputSet& files, const std::string& path, const viz::DrawList& picture) {
    if (path.ends_with(".vtm")) return write_vtm(files, path, picture);
    return files.write(path, [&](std::ostream& out) { viz::write_vtp(picture, out); });
}

Result<void> write_pictures(OutputSet& files, const OutputArguments& outputs,
                            const viz::DrawList& picture) {
    if (!outputs.svg.empty()) {
        if (picture.camera) {
            return fail(Errc::unsupported, outputs.svg +
                                               ": SVG knows no depth, so a scene of space can't be "
                                               "drawn in it; name a .png, .vtp or .vtm file");
        }
        const auto done =
            files.write(outputs.svg, [&](std::ostream& out) { viz::write_svg(picture, out); });
        if (!done) return done;
    }
    if (!outputs.vtk.empty()) {
        const auto done = write_vtk(files, outputs.vtk, picture);
        if (!done) return done;
    }
    if (outputs.png.empty()) return {};
    return files.write_named(
        outputs.png, [&](const std::string& name) { return viz::render_png(picture, name); });
}

}  // namespace

Result<void> check_outputs(const OutputArguments& outputs, const SceneArguments& scene) {
    if (!outputs.png.empty() && !viz::has_rendering()) {
        return fail(Errc::unsupported,
                    outputs.png + ": this program was built without VTK; write --svg instead");
    }
    std::vector<std::string> files = scene.files;
    files.insert(files.end(), scene.sheet_files.begin(), scene.sheet_files.end());
    return OutputSet::check(outputs.given(), files);
}

Result<void> write_outputs(const OutputArguments& outputs, const Document& document,
                           Session& session) {
    const auto start = Clock::now();
    session.progress().begin("writing");
    OutputSet files;
    if (!outputs.svg.empty() || !outputs.vtk.empty() || !outputs.png.empty()) {
        const auto done = write_pictures(files, outputs, document.picture());
        if (!done) return done;
    }
    const std::string json = outputs.given().empty() ? "-" : outputs.json;
    if (!json.empty()) {
        const auto done = write_json(files, json, document, session, start);
        if (!done) return done;
    }
    session.progress().clear();
    return files.commit();
}

}  // namespace sightline::detail
