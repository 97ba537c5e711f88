// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace sightline {

/// A typed index of 32 bits; `Tag::letter` is what it prints as (v12, e3, b0).
template <typename Tag>
struct Id {
    std::uint32_t value = std::numeric_limits<std::uint32_t>::max();

    /// The id that names nothing, e.g. the body of a wall.
    [[nodiscard]] static constexpr Id none() noexcept { return Id{}; }
    [[nodiscard]] constexpr bool is_none() const noexcept { return *this == none(); }
    [[nodiscard]] constexpr std::size_t index() const noexcept { return value; }

    friend constexpr auto operator<=>(const Id&, const Id&) = default;
};

template <typename Tag>
[[nodiscard]] std::string to_string(Id<Tag> id) {
    return id.is_none() ? std::string{Tag::letter} + "-" : Tag::letter + std::to_string(id.value);
}

struct BodyTag {
    static constexpr char letter = 'b';
};
struct VertexTag {
    static constexpr char letter = 'v';
};
struct EdgeTag {
    static constexpr char letter = 'e';
};
struct FaceTag {
    static constexpr char letter = 'f';
};

using BodyId = Id<BodyTag>;
using VertexId = Id<VertexTag>;
using EdgeId = Id<EdgeTag>;
using FaceId = Id<FaceTag>;

/// A vector indexed by one kind of id only.
template <typename IdType, typename T>
class PerId {
public:
    PerId() = default;
    explicit PerId(std::size_t n, const T& value = T{}) : data_(n, value) {}

    [[nodiscard]] decltype(auto) operator[](IdType id) { return data_[id.index()]; }
    [[nodiscard]] decltype(auto) operator[](IdType id) const { return data_[id.index()]; }
    [[nodiscard]] std::size_t size() const noexcept { return data_.size(); }
    [[nodiscard]] auto begin() const noexcept { return data_.begin(); }
    [[nodiscard]] auto end() const noexcept { return data_.end(); }

    friend bool operator==(const PerId&, const PerId&) = default;

private:
    std::vector<T> data_;
};

template <typename T>
using PerVertex = PerId<VertexId, T>;
template <typename T>
using PerEdge = PerId<EdgeId, T>;
template <typename T>
using PerBody = PerId<BodyId, T>;
template <typename T>
using PerFace = PerId<FaceId, T>;

}  // namespace sightline

template <typename Tag>
struct std::hash<sightline::Id<Tag>> {
    std::size_t operator()(sightline::Id<Tag> id) const noexcept {
        return std::hash<std::uint32_t>{}(id.value);
    }
};
