// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <memory>

#include "cli/document.hpp"
#include "cli/exact_json.hpp"
#include "cli/program.hpp"
#include "sightline/event/segment_transversals.hpp"
#include "sightline/event/triangle_tangents.hpp"
#include "sightline/viz/draw_transversals.hpp"

namespace sightline::detail {
namespace {

using Layout = JsonWriter::Layout;

struct TransversalArguments {
    std::string file;
    bool triangles = false;
    OutputArguments outputs;
};

Result<std::string> read_text(const std::string& file) {
    std::string text;
    if (file == "-") {
        text.assign(std::istreambuf_iterator<char>(std::cin), {});
        return text;
    }
    std::ifstream in(file, std::ios::binary);
    if (in) text.assign(std::istreambuf_iterator<char>(in), {});
    if (!in || in.bad()) {
        return fail(Errc::cannot_open,
                    fmt::format("{}: cannot be read ({}); check the name and the permissions", file,
                                std::strerror(errno)));
    }
    return text;
}

using detail::write_number;
void write_number(JsonWriter& json, const Rational& x) { json.value(x.to_string()); }

template <typename Number>
void write_plucker(JsonWriter& json, const BasicLine3<Number>& line) {
    json.begin_array(Layout::inline_);
    for (const Number& x : line.coordinates()) write_number(json, x);
    json.end();
}

template <typename Number>
void write_vector(JsonWriter& json, const BasicVector3<Number>& v) {
    json.begin_array(Layout::inline_);
    for (const Number* x : {&v.x, &v.y, &v.z}) write_number(json, *x);
    json.end();
}

template <typename Support>
void write_support(JsonWriter& json, const Support& support) {
    json.key("support");
    json.begin_array(Layout::inline_);
    for (const auto i : support) json.value(static_cast<std::uint32_t>(i));
    json.end();
}

template <typename Support>
void write_line(JsonWriter& json, const Support& support, std::uint8_t root,
                const SurdLine3& line) {
    json.begin_object(Layout::inline_);
    write_support(json, support);
    json.member("root", static_cast<std::uint32_t>(root));
    json.key("plucker");
    write_plucker(json, line);
    json.end();
}

void write_range(JsonWriter& json, const TransversalRange& range) {
    json.begin_object(Layout::inline_);
    json.key("from");
    write_plucker(json, range.from);
    json.key("through");
    write_plucker(json, range.through);
    json.key("to");
    write_plucker(json, range.to);
    if (!range.has_from) json.member("without_from", true);
    if (!range.has_to) json.member("without_to", true);
    json.end();
}

// What the kind of the component gives a meaning, and nothing else.
void write_shape(JsonWriter& json, const TransversalComponent& c) {
    const auto list = [&](const char* name, const auto& items, const auto& write) {
        if (items.empty()) return;
        json.key(name);
        json.begin_array(Layout::inline_);
        for (const auto& item : items) write(json, item);
        json.end();
    };
    json.member("kind", name_of(c.kind));
    if (c.point) {
        json.key("point");
        write_vector(json, vector_to(*c.point));
    }
    if (c.plane) {
        json.key("normal");
        write_vector(json, c.plane->normal);
        json.member("offset", c.plane->offset.to_string());
    }
    list("generators", c.generators, write_plucker<Rational>);
    list("ranges", c.ranges, write_range);
    list("extremal", c.extremal, write_plucker<Rational>);
    list("pieces", c.pieces, [](JsonWriter& out, const TransversalElement& e) {
        out.begin_array(Layout::inline_);
        write_vector(out, vector_to(e.source()));
        write_vector(out, vector_to(e.target()));
        out.end();
    });
}

void write_counts(JsonWriter& json, std::size_t objects, const char* name, std::size_t lines,
                  const std::map<std::string, std::size_t>& kinds) {
    json.key("counts");
    json.begin_object(Layout::inline_);
    json.member(name, objects);
    json.member("lines", lines);
    std::size_t components = 0;
    for (const auto& [kind, count] : kinds) components += count;
    json.member("components", components);
    for (const auto& [kind, count] : kinds) json.member(kind, count);
    json.end();
}

void write_segments_result(JsonWriter& json, const std::vector<RationalSegment3>& segments,
                           const SegmentTransversals& found) {
    json.begin_object();
    json.key("lines");
    json.begin_array();
    for (const auto& line : found.lines) {
        write_line(json, line.support, line.root, exact_line(segments, line));
    }
    json.end();
    json.key("components");
    json.begin_array();
    std::map<std::string, std::size_t> kinds;
    for (const auto& c : found.components) {
        ++kinds[name_of(c.component.kind)];
        json.begin_object(Layout::inline_);
        write_support(json, c.support);
        write_shape(json, c.component);
        json.end();
    }
    json.end();
    write_counts(json, segments.size(), "segments", found.lines.size(), kinds);
    json.end();
}

void write_triangles_result(JsonWriter& json, const TriangleTangents& found) {
    json.begin_object();
    json.key("lines");
    json.begin_array();
    for (const auto& line : found.lines) {
        // Edges through all triangles: 3 k + i joins corners i and i + 1 of triangle k.
        std::array<std::uint32_t, 4> support{};
        for (std::uint32_t k = 0; k < 4; ++k) support[k] = 3 * k + line.edges[k];
        write_line(json, support, line.root, line.line);
    }
    json.end();
    json.key("components");
    json.begin_array();
    std::map<std::string, std::size_t> kinds;
    for (const TransversalComponent& c : found.components) {
        ++kinds[name_of(c.kind)];
        json.begin_object(Layout::inline_);
        write_shape(json, c);
        json.end();
    }
    json.end();
    write_counts(json, 4, "triangles", found.lines.size(), kinds);
    json.end();
}

Document document_of(const TransversalArguments& arguments, const char* name, std::size_t count,
                     const Session& session) {
    Document document;
    document.kind = "transversals";
    document.inputs = {{"files", {arguments.file}}, {name, count}};
    document.options["arithmetic"] = name_of(session.common().arithmetic);
    if (arguments.triangles) document.options["triangles"] = true;
    return document;
}

Result<ExitStatus> finish(const TransversalArguments& arguments, const Document& document,
                          std::size_t lines, std::size_t components, Session& session) {
    const auto written = write_outputs(arguments.outputs, document, session);
    if (!written) return tl::unexpected(written.error());
    session.note(fmt::format("transversals: {} lines, {} components", lines, components));
    return ExitStatus::done;
}

Result<ExitStatus> run_segments(const TransversalArguments& arguments, const std::string& text,
                                Session& session) {
    const auto segments =
        session.timed("read", "reading", [&] { return read_segments(text, arguments.file); });
    if (!segments) return tl::unexpected(segments.error());
    TransversalOptions options;
    options.arithmetic = session.common().arithmetic;
    options.tally = &session.tally();
    options.limits = session.limits();
    const auto found = session.timed("build", "looking for lines",
                                     [&] { return transversals(*segments, options); });
    if (!found) return tl::unexpected(found.error());
    Document document = document_of(arguments, "segments", segments->size(), session);
    document.result = [&](JsonWriter& json) { write_segments_result(json, *segments, *found); };
    document.picture = [&] { return viz::draw(*segments, *found); };
    return finish(arguments, document, found->lines.size(), found->components.size(), session);
}

Result<ExitStatus> run_triangles(const TransversalArguments& arguments, const std::string& text,
                                 Session& session) {
    const auto read =
        session.timed("read", "reading", [&] { return read_triangles(text, arguments.file); });
    if (!read) return tl::unexpected(read.error());
    if (read->size() != 4) {
        return fail(Errc::bad_parameter,
                    fmt::format("{}: {} triangles are given; tangents are asked of four",
                                arguments.file, read->size()));
    }
    const std::array<RationalTriangle3, 4> four{read->at(0), read->at(1), read->at(2), read->at(3)};
    const TriangleTangents found =
        session.timed("build", "looking for lines", [&] { return triangle_tangents(four); });
    Document document = document_of(arguments, "triangles", 4, session);
    document.result = [&](JsonWriter& json) { write_triangles_result(json, found); };
    document.picture = [&] { return viz::draw(four, found); };
    return finish(arguments, document, found.lines.size(), found.components.size(), session);
}

Result<ExitStatus> run_transversals(const TransversalArguments& arguments, Session& session) {
    if (arguments.triangles && session.common().arithmetic != Arithmetic::filtered &&
        session.common().arithmetic != Arithmetic::exact) {
        return fail(Errc::bad_parameter,
                    "--triangles: only exact numbers are used; leave out --arithmetic");
    }
    SceneArguments inputs;
    inputs.files = {arguments.file};
    if (const auto checked = check_outputs(arguments.outputs, inputs); !checked) {
        return tl::unexpected(checked.error());
    }
    const Result<std::string> text = read_text(arguments.file);
    if (!text) return tl::unexpected(text.error());
    return arguments.triangles ? run_triangles(arguments, *text, session)
                               : run_segments(arguments, *text, session);
}

}  // namespace

void add_transversals(Program& program) {
    const auto arguments = std::make_shared<TransversalArguments>();
    CLI::App& app = program.add(
        "transversals", "all lines through four segments, or tangent to four triangles",
        "sightline transversals segments.txt -o lines.json",
        [arguments](Session& session) { return run_transversals(*arguments, session); });
    app.add_option(
           "FILE", arguments->file,
           "six numbers a segment, decimal or p/q, taken exactly; # comments; - is standard "
           "input")
        ->required()
        ->type_name("");
    app.add_flag("--triangles", arguments->triangles,
                 "four triangles, nine numbers each: lines through a boundary point of each that "
                 "enter none");
    add_output_arguments(app, arguments->outputs);
}

}  // namespace sightline::detail
