// SPDX-License-Identifier: GPL-3.0-or-later
#include "sightline/scene/doom.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "scene/families_support.hpp"

namespace sightline {
namespace {

using families_test::points_of;
using testing::ElementsAre;
using testing::HasSubstr;

using Bytes = std::vector<std::byte>;

void put(Bytes& bytes, std::uint32_t value, int count) {
    for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::byte>(value >> (8 * i)));
}

/// Builds a WAD lump by lump.
class WadBuilder {
public:
    explicit WadBuilder(std::string magic = "PWAD") : magic_(std::move(magic)) {}
    WadBuilder& lump(const std::string& name, const Bytes& bytes = {}) {
        entries_.push_back({name, static_cast<std::uint32_t>(12 + data_.size()),
                            static_cast<std::uint32_t>(bytes.size())});
        data_.insert(data_.end(), bytes.begin(), bytes.end());
        return *this;
    }
    [[nodiscard]] Bytes bytes() const {
        Bytes wad;
        for (const char c : magic_) wad.push_back(static_cast<std::byte>(c));
        put(wad, static_cast<std::uint32_t>(entries_.size()), 4);
        put(wad, static_cast<std::uint32_t>(12 + data_.size()), 4);
        wad.insert(wad.end(), data_.begin(), data_.end());
        for (const Entry& entry : entries_) {
            put(wad, entry.offset, 4);
            put(wad, entry.size, 4);
            for (std::size_t i = 0; i < 8; ++i) {
                wad.push_back(static_cast<std::byte>(i < entry.name.size() ? entry.name[i] : 0));
            }
        }
        return wad;
    }

private:
    struct Entry {
        std::string name;
        std::uint32_t offset;
        std::uint32_t size;
    };
    std::string magic_;
    Bytes data_;
    std::vector<Entry> entries_;
};

Bytes vertexes(const std::vector<std::pair<int, int>>& points) {
    Bytes bytes;
    for (const auto& [x, y] : points) {
        put(bytes, static_cast<std::uint32_t>(x), 2);
        put(bytes, static_cast<std::uint32_t>(y), 2);
    }
    return bytes;
}

struct Line {
    std::uint32_t from;
    std::uint32_t to;
    bool two_sided = false;
};
Bytes linedefs(const std::vector<Line>& lines, bool hexen = false) {
    Bytes bytes;
    for (const Line& line : lines) {
        put(bytes, line.from, 2);
        put(bytes, line.to, 2);
        put(bytes, 0, hexen ? 4 : 2);
        put(bytes, 0, 4);
        put(bytes, 0, 2);
        put(bytes, line.two_sided ? 1 : 0xFFFF, 2);
    }
    return bytes;
}

const std::vector<std::pair<int, int>> square{{-64, -64}, {64, -64}, {64, 64}, {-64, 64}};

/// A square room; a two-sided line along its diagonal.
WadBuilder room(const std::string& name = "MAP01") {
    WadBuilder wad;
    wad.lump("PLAYPAL", Bytes(5)).lump(name).lump("THINGS");
    wad.lump("LINEDEFS", linedefs({{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 2, true}}));
    wad.lump("SIDEDEFS").lump("VERTEXES", vertexes(square));
    return wad;
}

std::string message(const Result<SceneInput2>& result) {
    return result ? "no error" : result.error().message;
}

TEST(ReadDoom, ReadsOneSidedLinesAsAClosedChain) {
    const Result<SceneInput2> scene = read_doom(room().bytes(), "MAP01");
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_FALSE(scene->world);
    ASSERT_EQ(scene->elements.size(), 1U);
    const auto& wall = std::get<Polyline2>(scene->elements.front());
    ASSERT_EQ(wall.points.size(), 5U);
    EXPECT_EQ(wall.points.front(), wall.points.back());
    for (std::size_t i = 1; i < 5; ++i) {
        const Point2& p = wall.points[i - 1];
        const Point2& q = wall.points[i];
        EXPECT_EQ(std::abs(p.x - q.x) + std::abs(p.y - q.y), 128);
    }
    EXPECT_TRUE(Scene2::make(*scene));
}

TEST(ReadDoom, ReadsAllLinesWhenAsked) {
    const Result<SceneInput2> scene = read_doom(room().bytes(), "MAP01", {.all_lines = true});
    ASSERT_TRUE(scene);
    // Two branching points, three chains between them: two sides each way, and the diagonal.
    ASSERT_EQ(scene->elements.size(), 3U);
    EXPECT_EQ(points_of(*scene).size(), 3U + 3U + 2U);
    EXPECT_TRUE(Scene2::make(*scene));
}

TEST(ReadDoom, FindsMapsByNameInAnyCase) {
    Bytes wad = room("E1M1").bytes();
    EXPECT_TRUE(read_doom(wad, "e1m1"));
    EXPECT_THAT(*doom_maps(wad), ElementsAre("E1M1"));
    const Result<SceneInput2> missing = read_doom(wad, "MAP07");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, Errc::bad_parameter);
    EXPECT_THAT(missing.error().message, HasSubstr("'MAP07'"));
    EXPECT_THAT(missing.error().message, HasSubstr("E1M1"));
    EXPECT_FALSE(read_doom(wad, "PLAYPAL"));
    EXPECT_FALSE(read_doom(wad, "LINEDEFS"));
}

TEST(ReadDoom, TakesTheLumpsOfTheRightMap) {
    WadBuilder wad;
    wad.lump("MAP01")
        .lump("LINEDEFS", linedefs({{0, 1}}))
        .lump("VERTEXES", vertexes({{0, 0}, {1, 0}}));
    wad.lump("MAP02")
        .lump("LINEDEFS", linedefs({{0, 1}}))
        .lump("VERTEXES", vertexes({{0, 0}, {2, 0}}));
    const Bytes bytes = wad.bytes();
    EXPECT_THAT(*doom_maps(bytes), ElementsAre("MAP01", "MAP02"));
    EXPECT_THAT(points_of(*read_doom(bytes, "MAP02")), ElementsAre(Point2{0, 0}, Point2{2, 0}));
}

TEST(ReadDoom, ReadsHexensLongerLinedefs) {
    WadBuilder wad;
    wad.lump("MAP01").lump("LINEDEFS", linedefs({{0, 1}, {1, 2, true}}, true));
    wad.lump("VERTEXES", vertexes(square)).lump("BEHAVIOR");
    const Result<SceneInput2> scene = read_doom(wad.bytes(), "MAP01");
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_THAT(points_of(*scene), ElementsAre(Point2{-64, -64}, Point2{64, -64}));
}

TEST(ReadDoom, LeavesOutRepeatsAndLinesWithoutLength) {
    WadBuilder wad;
    wad.lump("MAP01").lump("LINEDEFS", linedefs({{0, 1}, {1, 0}, {0, 1}, {2, 2}, {3, 4}}));
    wad.lump("VERTEXES", vertexes({{0, 0}, {9, 0}, {5, 5}, {7, 7}, {7, 7}}));
    const Result<SceneInput2> scene = read_doom(wad.bytes(), "MAP01");
    ASSERT_TRUE(scene);
    EXPECT_EQ(points_of(*scene).size(), 2U);
}

TEST(ReadDoom, JoinsLinesThatMeetAtTheSamePlaceUnderDifferentNumbers) {
    WadBuilder wad;
    wad.lump("MAP01").lump("LINEDEFS", linedefs({{0, 1}, {2, 3}}));
    wad.lump("VERTEXES", vertexes({{0, 0}, {9, 0}, {9, 0}, {9, 9}}));
    EXPECT_THAT(points_of(*read_doom(wad.bytes(), "MAP01")),
                ElementsAre(Point2{0, 0}, Point2{9, 0}, Point2{9, 9}));
}

TEST(ReadDoom, SaysWhatIsWrongWithAFileInOneLine) {
    const auto expect_error = [](const Bytes& wad, Errc code, const std::string& text) {
        const Result<SceneInput2> scene = read_doom(wad, "MAP01", {}, "x.wad");
        ASSERT_FALSE(scene) << text;
        EXPECT_EQ(scene.error().code, code) << scene.error().message;
        EXPECT_THAT(scene.error().message, HasSubstr(text));
        EXPECT_THAT(scene.error().message, testing::StartsWith("x.wad: "));
        EXPECT_EQ(scene.error().message.find('\n'), std::string::npos);
    };
    const auto map_with = [](const Bytes& lines, const Bytes& points) {
        return WadBuilder().lump("MAP01").lump("LINEDEFS", lines).lump("VERTEXES", points).bytes();
    };
    expect_error({}, Errc::syntax, "not a WAD");
    expect_error(Bytes(100, std::byte{'x'}), Errc::syntax, "not a WAD");
    expect_error(WadBuilder("PK\3\4").lump("MAP01").bytes(), Errc::syntax, "not a WAD");
    Bytes cut = room().bytes();
    cut.pop_back();
    expect_error(cut, Errc::syntax, "directory");
    Bytes huge = room().bytes();
    for (std::size_t i = 4; i < 8; ++i) huge[i] = std::byte{0xFF};  // so many lumps
    expect_error(huge, Errc::syntax, "directory");
    Bytes beyond = room().bytes();
    beyond[beyond.size() - 3 * 16 + 7] = std::byte{0x7F};  // the size of LINEDEFS
    expect_error(beyond, Errc::syntax, "lump LINEDEFS ends beyond");
    expect_error(WadBuilder().bytes(), Errc::bad_parameter, "no maps");
    expect_error(WadBuilder().lump("MAP01").lump("TEXTMAP").bytes(), Errc::unsupported, "UDMF");
    expect_error(map_with(linedefs({{0, 4}}), vertexes(square)), Errc::syntax,
                 "linedef 0 names vertex 4 of 4");
    expect_error(map_with(linedefs({{0, 1, true}}), vertexes(square)), Errc::empty_scene,
                 "all lines");
    expect_error(map_with(Bytes(15), vertexes(square)), Errc::syntax, "not a multiple of 14");
    expect_error(map_with(linedefs({{0, 1}}), Bytes(7)), Errc::syntax, "not a multiple of 4");
    expect_error(WadBuilder().lump("MAP01").lump("LINEDEFS", linedefs({{0, 1}})).bytes(),
                 Errc::syntax, "no VERTEXES");
}

TEST(ReadDoom, SurvivesCutAndSpoiltFiles) {
    const Bytes good = room().bytes();
    for (std::size_t size = 0; size < good.size(); ++size) {
        EXPECT_FALSE(read_doom(std::span(good).first(size), "MAP01")) << size;
    }
    std::mt19937_64 random(7);
    for (int round = 0; round < 20000; ++round) {
        Bytes bad = good;
        for (int i = 0; i < 3; ++i) bad[random() % bad.size()] = static_cast<std::byte>(random());
        const Result<SceneInput2> scene = read_doom(bad, "MAP01");
        if (!scene) {
            EXPECT_FALSE(scene.error().message.empty());
        }
    }
}

TEST(ReadDoom, SaysWhenAFileCannotBeRead) {
    const Result<SceneInput2> scene = read_doom(std::string("/nonexistent/doom.wad"), "MAP01");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, Errc::cannot_open);
    EXPECT_THAT(message(scene), HasSubstr("/nonexistent/doom.wad"));
    EXPECT_FALSE(doom_maps(std::string("/nonexistent/doom.wad")));
    EXPECT_EQ(doom_maps(std::string("/")).error().code, Errc::cannot_open) << "a directory";
}

class Freedoom : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Both, Freedoom, testing::Values("freedoom1.wad", "freedoom2.wad"));

TEST_P(Freedoom, EveryMapReads) {
    const std::string path = std::string("/usr/share/games/doom/") + GetParam();
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << path << " is not installed (package freedoom)";
    std::ifstream stream(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(stream), {});
    const auto wad = std::as_bytes(std::span(text));
    const Result<std::vector<std::string>> maps = doom_maps(wad);
    ASSERT_TRUE(maps);
    EXPECT_EQ(maps->size(), std::string(GetParam()) == "freedoom1.wad" ? 36U : 32U);
    EXPECT_EQ(*doom_maps(path), *maps);
    for (const std::string& map : *maps) {
        const Result<SceneInput2> walls = read_doom(wad, map);
        ASSERT_TRUE(walls) << message(walls);
        const Result<SceneInput2> all = read_doom(wad, map, {.all_lines = true});
        ASSERT_TRUE(all) << message(all);
        EXPECT_GT(points_of(*all).size(), points_of(*walls).size());
        const Result<Scene2> made = Scene2::make(*walls);
        EXPECT_TRUE(made) << map << ": " << made.error().message;
        const Result<Scene2> made_all = Scene2::make(*all);
        EXPECT_TRUE(made_all) << map << ": " << made_all.error().message;
    }
}

}  // namespace
}  // namespace sightline
