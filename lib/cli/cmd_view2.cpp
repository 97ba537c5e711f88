// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <memory>
#include <mutex>

#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "cli/picture.hpp"
#include "cli/program.hpp"
#include "sightline/planar/clip_view.hpp"
#include "sightline/planar/visibility_polygon.hpp"

namespace sightline::detail {
namespace {

struct ViewArguments {
    SceneArguments scene;
    OutputArguments outputs;
    std::vector<std::string> from;
    std::string from_file;
    std::string clip;
    bool with_needles = false;
};

/// What is asked for, read and checked.
struct ViewQuestion {
    std::vector<RationalPoint2> from;
    std::vector<std::string> names;  ///< of the viewpoints, for messages
    std::optional<RationalBox2> clip;
    bool is_list = false;
};

Result<void> read_points(std::istream& in, const std::string& file, ViewQuestion& question) {
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        line.erase(std::min(line.find('#'), line.size()));
        if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
        std::string name = fmt::format("{}:{}", file, number);
        const Result<RationalPoint2> p = parse_point(name, line);
        if (!p) return tl::unexpected(p.error());
        question.from.push_back(*p);
        question.names.push_back(std::move(name));
    }
    return {};
}

Result<void> read_point_file(const std::string& file, ViewQuestion& question) {
    if (file == "-") return read_points(std::cin, "standard input", question);
    std::ifstream in(file);
    if (!in) {
        return fail(Errc::cannot_open,
                    fmt::format("{}: cannot be read ({}); check the name and the permissions", file,
                                std::strerror(errno)));
    }
    return read_points(in, file, question);
}

Result<RationalBox2> parse_box(const std::string& text) {
    std::size_t middle = text.find(',');
    if (middle != std::string::npos) middle = text.find(',', middle + 1);
    if (middle != std::string::npos) {
        const auto low = parse_point("--clip", std::string_view(text).substr(0, middle));
        const auto high = parse_point("--clip", std::string_view(text).substr(middle + 1));
        if (low && high && low->x < high->x && low->y < high->y) return RationalBox2{*low, *high};
    }
    return fail(Errc::bad_parameter,
                fmt::format("--clip: '{}' is no box; write X0,Y0,X1,Y1 with X0 < X1 and Y0 < Y1, "
                            "as in -1,-1,5/2,3",
                            text));
}

Result<ViewQuestion> question_of(const ViewArguments& arguments) {
    ViewQuestion question;
    for (const std::string& text : arguments.from) {
        const Result<RationalPoint2> p = parse_point("--from", text);
        if (!p) return tl::unexpected(p.error());
        question.from.push_back(*p);
        question.names.push_back("--from " + text);
    }
    if (!arguments.from_file.empty()) {
        const Result<void> read = read_point_file(arguments.from_file, question);
        if (!read) return tl::unexpected(read.error());
    }
    if (question.from.empty()) {
        return fail(Errc::bad_parameter, "no viewpoint is named; give --from X,Y or --from-file");
    }
    question.is_list = question.from.size() > 1 || !arguments.from_file.empty();
    if (arguments.clip.empty()) return question;
    const Result<RationalBox2> box = parse_box(arguments.clip);
    if (!box) return tl::unexpected(box.error());
    question.clip = *box;
    for (std::size_t i = 0; i < question.from.size(); ++i) {
        if (!box->contains(question.from[i])) {
            return fail(Errc::bad_parameter, question.names[i] +
                                                 ": lies outside of the box of --clip; make the "
                                                 "box larger");
        }
    }
    return question;
}

ExactView exact_view(const Scene2& scene, const VisibilityPolygon& polygon,
                     const std::optional<RationalBox2>& clip) {
    ExactView view{polygon.from, exact_ring(scene, polygon), {}};
    if (clip) view.ring = clipped_ring(view.from, view.ring, *clip);
    for (const Needle& needle : polygon.needles) {
        std::pair ends{exact_point(scene, polygon.from, needle.near),
                       exact_point(scene, polygon.from, needle.far)};
        if (!clip) {
            view.needles.push_back(std::move(ends));
        } else if (auto part = clipped_needle(view.from, ends, *clip)) {
            view.needles.push_back(std::move(*part));
        }
    }
    return view;
}

/// The views from all points, in their order, as far as time allows: `done` of them.
struct Views {
    std::vector<Result<VisibilityPolygon>> polygons;
    std::vector<char> is_done;
};

Views look(const Scene2& scene, const ViewQuestion& question, bool with_needles, Session& session) {
    const PointVisibility2 visibility(scene);
    const std::size_t n = question.from.size();
    Views views{std::vector<Result<VisibilityPolygon>>(n), std::vector<char>(n, 0)};
    std::atomic<std::size_t> finished{0};
    std::mutex tally_mutex;
    const auto look_from = [&](const tbb::blocked_range<std::size_t>& range) {
        Tally tally;
        VisibilityPolygonOptions options;
        options.needles = with_needles ? Needles::with_needles : Needles::regularised;
        options.arithmetic = session.common().arithmetic;
        options.tally = &tally;
        for (std::size_t i = range.begin(); i < range.end() && !session.is_over(); ++i) {
            views.polygons[i] = visibility.from(question.from[i], options);
            views.is_done[i] = 1;
            session.progress().update(static_cast<double>(++finished) / static_cast<double>(n));
        }
        const std::lock_guard lock(tally_mutex);
        session.tally() += tally;
    };
    const unsigned threads = session.common().threads;
    tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads));
    arena.execute([&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n), look_from); });
    return views;
}

void write_view_point(JsonWriter& json, const ViewPoint& p) {
    if (!p.at_infinity) return write_point(json, p.coordinates);
    json.begin_object(JsonWriter::Layout::inline_);
    json.key("direction");
    write_point(json, p.coordinates);
    json.end();
}

void write_view(JsonWriter& json, const ExactView& view) {
    json.begin_object();
    json.key("from");
    write_point(json, view.from);
    json.key("ring");
    json.begin_array();
    for (const ViewPoint& p : view.ring) write_view_point(json, p);
    json.end();
    json.key("needles");
    json.begin_array();
    for (const auto& [near, far] : view.needles) {
        json.begin_array(JsonWriter::Layout::inline_);
        write_view_point(json, near);
        write_view_point(json, far);
        json.end();
    }
    json.end();
    json.end();
}

void write_views(JsonWriter& json, const Scene2& scene, const Views& views,
                 const ViewQuestion& question) {
    if (question.is_list) {
        json.begin_object();
        json.key("polygons");
        json.begin_array();
    }
    for (std::size_t i = 0; i < views.polygons.size(); ++i) {
        if (views.is_done[i] == 0) continue;
        write_view(json, exact_view(scene, *views.polygons[i], question.clip));
    }
    if (question.is_list) {
        json.end();
        json.end();
    }
}

viz::DrawList draw_views(const Scene2& scene, const Views& views, const ViewQuestion& question) {
    std::vector<ResultFile> results(1);
    results.front().kind = "visibility_polygon";
    results.front().scene_vertices = scene.vertex_count();
    results.front().options = nlohmann::json::object();
    for (std::size_t i = 0; i < views.polygons.size(); ++i) {
        if (views.is_done[i] == 0) continue;
        results.front().views.push_back(exact_view(scene, *views.polygons[i], question.clip));
    }
    return *picture_of(scene, results, {});
}

nlohmann::ordered_json options_of(const ViewArguments& arguments, const ViewQuestion& question,
                                  const Session& session) {
    nlohmann::ordered_json options;
    options["arithmetic"] = name_of(session.common().arithmetic);
    options["with_needles"] = arguments.with_needles;
    if (question.clip) {
        options["clip"] = nlohmann::ordered_json::array(
            {to_json(question.clip->low), to_json(question.clip->high)});
    }
    return options;
}

/// The first point without an answer, or the limit when nothing may be left out.
Result<void> problem_of(const Views& views, const ViewQuestion& question, const Session& session) {
    for (std::size_t i = 0; i < views.polygons.size(); ++i) {
        if (views.is_done[i] != 0 && !views.polygons[i]) {
            const Error& error = views.polygons[i].error();
            return fail(error.code, question.names[i] + ": " + error.message);
        }
    }
    const auto done = std::count(views.is_done.begin(), views.is_done.end(), 1);
    if (done == 0) return fail(Errc::cancelled, session.limit_message());
    return {};
}

Result<ExitStatus> run_view2(const ViewArguments& arguments, Session& session) {
    if (const auto checked = check_outputs(arguments.outputs, arguments.scene); !checked) {
        return tl::unexpected(checked.error());
    }
    const Result<ViewQuestion> question = question_of(arguments);
    if (!question) return tl::unexpected(question.error());
    const Result<LoadedScene> loaded = load_scene(arguments.scene, session);
    if (!loaded) return tl::unexpected(loaded.error());
    session.keep_from_now_on();
    const Views views = session.timed("build", "looking", [&] {
        return look(loaded->scene, *question, arguments.with_needles, session);
    });
    if (const auto fine = problem_of(views, *question, session); !fine) {
        return tl::unexpected(fine.error());
    }
    const auto done =
        static_cast<std::size_t>(std::count(views.is_done.begin(), views.is_done.end(), 1));

    Document document;
    document.kind = "visibility_polygon";
    document.scene = &*loaded;
    document.options = options_of(arguments, *question, session);
    document.complete = done == views.polygons.size();
    document.result = [&](JsonWriter& json) { write_views(json, loaded->scene, views, *question); };
    document.picture = [&] { return draw_views(loaded->scene, views, *question); };
    const auto written = write_outputs(arguments.outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    if (!document.complete) {
        return fail(Errc::limit_reached,
                    fmt::format("{}; {} of {} views are written", session.limit_message(), done,
                                views.polygons.size()));
    }
    session.note(fmt::format("view2: {} views", done));
    return ExitStatus::done;
}

}  // namespace

void add_view2(Program& program) {
    const auto arguments = std::make_shared<ViewArguments>();
    CLI::App& app =
        program.add("view2", "visibility polygons of points",
                    "sightline view2 map.wkt --from 1.5,7/3 --clip -10,-10,10,10 -o view.json",
                    [arguments](Session& session) { return run_view2(*arguments, session); });
    add_scene_arguments(app, arguments->scene);
    app.add_option("--from", arguments->from,
                   "viewpoint, repeatable; exact: decimals or fractions p/q")
        ->type_name("X,Y")
        ->take_all()
        ->allow_extra_args(false);
    app.add_option("--from-file", arguments->from_file,
                   "viewpoints, X,Y on a line each; # begins a comment; - is standard input")
        ->type_name("FILE");
    app.add_option("--clip", arguments->clip, "only what lies in this box")
        ->type_name("X0,Y0,X1,Y1");
    app.add_flag("--with-needles", arguments->with_needles,
                 "also what is seen as a segment only, e.g. through a pinhole");
    program.allow_partial(app);
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
