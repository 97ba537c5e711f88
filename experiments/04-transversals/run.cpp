// SPDX-License-Identifier: GPL-3.0-or-later
// Lines through four segments: known counts, what exactness costs, and what doubles get wrong.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "common/measure.hpp"
#include "common/table.hpp"
#include "sightline/event/segment_file.hpp"
#include "sightline/event/segment_transversals.hpp"
#include "sightline/event/triangle_tangents.hpp"

namespace sightline::experiments {
namespace {

using Segments = std::vector<RationalSegment3>;

struct Options {
    std::string data;
    std::string out;
    std::uint64_t seed = 1;
};

// Published counts of lines.
const std::map<std::string, std::size_t> known_lines{
    {"10_rand", 15},        {"30_rand", 2620},        {"50_rand", 20742},
    {"10_long", 67},        {"50_long", 80016},       {"40_grid_perturbed", 11936},
    {"thin_triangles", 62}, {"thin_triangles_25", 60}};
constexpr std::size_t known_degenerate = 2283;  // quadruples of 40_grid_perturbed

std::string text_of(const std::string& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(file + ": cannot be read");
    return {std::istreambuf_iterator<char>(in), {}};
}

// Numbers from a grid of so many steps, each moved by up to four times `nudge`.
Segments drawn(std::uint64_t seed, int count, int grid, double nudge) {
    std::mt19937_64 bits(seed);
    const auto below = [&](int n) { return static_cast<int>(bits() % static_cast<unsigned>(n)); };
    const auto point = [&] {
        std::array<Rational, 3> x;
        for (Rational& c : x) c = Rational(below(grid)) + Rational(below(5)) * Rational(nudge);
        return RationalPoint3{x[0], x[1], x[2]};
    };
    Segments segments;
    for (int i = 0; i < count; ++i) {
        RationalPoint3 a = point(), b = point();
        segments.push_back({std::move(a), std::move(b)});
    }
    return segments;
}

std::size_t count_missing(const SegmentTransversals& from, const SegmentTransversals& in) {
    std::vector<SegmentTransversals::Line> missing;
    std::set_difference(in.lines.begin(), in.lines.end(), from.lines.begin(), from.lines.end(),
                        std::back_inserter(missing));
    return missing.size();
}

std::string verdict(const std::string& input, std::size_t lines) {
    const auto known = known_lines.find(input);
    if (known == known_lines.end()) return "-";
    return known->second == lines ? "as known" : fmt::format("{} expected", known->second);
}

void run_segments(const std::string& input, const Segments& segments, Table& table,
                  bool& is_right) {
    using enum Arithmetic;
    const auto name = [](Arithmetic a) {
        return a == filtered   ? "filtered"
               : a == exact    ? "exact"
               : a == interval ? "interval"
                               : "double";
    };
    const SegmentTransversals truth = transversals(segments).value();
    double of_doubles = 0;
    for (const Arithmetic arithmetic : {double_, filtered, interval, exact}) {
        Tally tally;
        TransversalOptions options;
        options.arithmetic = arithmetic;
        options.tally = &tally;
        const SegmentTransversals found = transversals(segments, options).value();
        options.tally = nullptr;
        const bool is_slow = arithmetic == exact;
        const Timing timing = measure([&] { return transversals(segments, options).value(); },
                                      is_slow ? Effort{1, 0, 1} : Effort{5, 0.3, 100});
        if (arithmetic == double_) of_doubles = timing.thread;
        const TierCounts& counts = tally[Predicate::transversals3];
        const std::string known =
            arithmetic == filtered ? verdict(input, found.lines.size()) : std::string("-");
        is_right = is_right && known.find("expected") == std::string::npos;
        table.add({input, name(arithmetic), fmt::format("{}", segments.size()),
                   fmt::format("{}", counts.calls), fmt::format("{}", found.lines.size()),
                   fmt::format("{}", found.components.size()),
                   fmt::format("{}", count_missing(found, truth)),
                   fmt::format("{}", count_missing(truth, found)),
                   fmt::format("{:.3f}", 1e3 * timing.thread),
                   fmt::format("{:.3f}", 1e6 * timing.thread / static_cast<double>(counts.calls)),
                   fmt::format("{:.2f}", timing.thread / of_doubles),
                   fmt::format("{}", counts.filter), fmt::format("{}", counts.interval),
                   fmt::format("{}", counts.exact), fmt::format("{}", counts.undecided), known});
    }
}

// Quadruples whose four whole lines have infinitely many common transversals, by what those are
// and by what the segments leave of them.
void describe_degenerate(const Segments& segments, bool& is_right) {
    std::vector<TransversalElement> lines;
    for (const RationalSegment3& s : segments) {
        lines.push_back(TransversalElement::line(s.source, s.target));
    }
    std::map<SegmentSupport, std::string> kinds;
    const auto n = static_cast<std::uint32_t>(segments.size());
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = i + 1; j < n; ++j) {
            for (std::uint32_t k = j + 1; k < n; ++k) {
                for (std::uint32_t l = k + 1; l < n; ++l) {
                    const std::array four{lines[i], lines[j], lines[k], lines[l]};
                    if (lines_meeting({four[0].carrier(), four[1].carrier(), four[2].carrier(),
                                       four[3].carrier()})) {
                        continue;
                    }
                    std::string kind;
                    for (const auto& c : transversals(four).components) {
                        kind += (kind.empty() ? "" : " and ") + std::string(name_of(c.kind));
                    }
                    kinds[{i, j, k, l}] = kind.empty() ? "no line" : kind;
                }
            }
        }
    }
    const SegmentTransversals cut = transversals(segments).value();
    std::map<std::string, std::pair<std::size_t, std::size_t>> table;
    for (const auto& [support, kind] : kinds) {
        const bool is_left = std::ranges::any_of(
            cut.components, [&](const auto& c) { return c.support == support; });
        table[kind].first += 1;
        table[kind].second += is_left ? 1 : 0;
    }
    fmt::print("degenerate quadruples: {} ({} known)\n", kinds.size(), known_degenerate);
    for (const auto& [kind, count] : table) {
        fmt::print("  {}: {}, of which the segments leave a component in {}\n", kind, count.first,
                   count.second);
    }
    is_right = is_right && kinds.size() == known_degenerate;
}

// Every number cut to so many decimals.
std::string cut_decimals(const std::string& text, std::size_t decimals) {
    std::istringstream in(text);
    std::string result;
    for (std::string line; std::getline(in, line);) {
        std::istringstream words(line.substr(0, line.find('#')));
        for (std::string word; words >> word;) {
            const std::size_t point = word.find('.');
            if (point != std::string::npos) word = word.substr(0, point + 1 + decimals);
            result += word + " ";
        }
        result += '\n';
    }
    return result;
}

void run_triangles(const std::string& input, const std::string& text, bool& is_right) {
    const auto t = read_triangles(text, input).value();
    const std::array<RationalTriangle3, 4> four{t.at(0), t.at(1), t.at(2), t.at(3)};
    const double start = thread_seconds();
    const TriangleTangents found = triangle_tangents(four);
    const double seconds = thread_seconds() - start;
    const auto certified = std::ranges::count_if(found.lines, [&](const auto& l) {
        return l.line.is_line() &&
               std::ranges::all_of(four, [&](const auto& x) { return is_tangent(l.line, x); });
    });
    const std::string known = verdict(input, found.lines.size());
    fmt::print("{}: {} common tangents, {} certified, {} components, {:.2f} s ({})\n", input,
               found.lines.size(), certified, found.components.size(), seconds, known);
    is_right = is_right && known.find("expected") == std::string::npos &&
               static_cast<std::size_t>(certified) == found.lines.size();
}

int main_of(const Options& options) {
    const std::string head = provenance() + fmt::format("# seed: {}\n", options.seed);
    std::cout << head << std::flush;
    Table table({"input", "arithmetic", "segments", "quadruples", "lines", "components", "missing",
                 "false", "cpu_ms", "us_per_quadruple", "to_double", "filter", "interval", "exact",
                 "undecided", "known"});
    bool is_right = true;
    if (!options.data.empty()) {
        for (const char* input :
             {"10_rand", "30_rand", "50_rand", "10_long", "50_long", "40_grid_perturbed"}) {
            const std::string file = options.data + "/lts/" + input + ".txt";
            run_segments(input, read_segments(text_of(file), file).value(), table, is_right);
        }
    }
    run_segments("random", drawn(options.seed, 40, 1 << 20, 0), table, is_right);
    run_segments("nearly_degenerate", drawn(options.seed, 24, 5, 0x1p-45), table, is_right);
    run_segments("degenerate", drawn(options.seed, 20, 4, 0), table, is_right);
    if (!options.out.empty()) table.write_csv(options.out, head);
    if (!options.data.empty()) {
        const std::string grid = options.data + "/lts/40_grid_perturbed.txt";
        describe_degenerate(read_segments(text_of(grid), grid).value(), is_right);
        const std::string thin = text_of(options.data + "/four_thin_triangles_62.txt");
        run_triangles("thin_triangles", thin, is_right);
        run_triangles("thin_triangles_25", cut_decimals(thin, 25), is_right);
    }
    fmt::print("{}\n", is_right ? "all known counts found" : "a known count is DIFFERENT");
    return is_right ? 0 : 1;
}

}  // namespace
}  // namespace sightline::experiments

int main(int argc, char** argv) {
    CLI::App app("Lines through four of many segments, and tangent to four triangles");
    sightline::experiments::Options options;
    app.add_option("--data", options.data,
                   "folder with lts/*.txt and four_thin_triangles_62.txt; left out without it");
    app.add_option("--out", options.out, "CSV file to write");
    app.add_option("--seed", options.seed)->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    return sightline::experiments::main_of(options);
}
