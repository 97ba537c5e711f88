// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh_text.hpp"

#include <charconv>

namespace sightline::detail {

void MeshText::skip_line() {
    const std::size_t end = cursor_.rest().find('\n');
    cursor_.advance(end == std::string_view::npos ? cursor_.rest().size() : end);
}

bool MeshText::at_line_end() {
    cursor_.skip_blanks();
    if (cursor_.peek() == '#') skip_line();
    return cursor_.at_end() || cursor_.peek() == '\n';
}

void MeshText::skip_to_content() {
    for (cursor_.skip_space(); cursor_.peek() == '#' && !cursor_.at_end(); cursor_.skip_space())
        skip_line();
}

bool MeshText::integer(std::int64_t& value) {
    const std::string_view rest = cursor_.rest();
    const auto result = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (result.ec != std::errc{})
        return cursor_.refuse(Errc::syntax, "expected a whole number, " + cursor_.found());
    const auto used = static_cast<std::size_t>(result.ptr - rest.data());
    const char next = used < rest.size() ? rest[used] : ' ';
    if (next != '/' && next != '#' && next != ' ' && (next < '\t' || next > '\r'))
        return cursor_.refuse(Errc::syntax, "expected a whole number, " + cursor_.found());
    cursor_.advance(used);
    last_number_ = used;
    return true;
}

bool MeshText::refuse_number(Errc code, std::string_view what) {
    cursor_.retreat(last_number_);
    return cursor_.refuse(code, what);
}

bool MeshText::count() {
    if (++elements_ <= max_elements_) return true;
    return cursor_.refuse(Errc::limit_reached, "the mesh is larger than the limit; split it");
}

bool MeshText::vertex() {
    Point3 p;
    const std::uint32_t line = cursor_.line();
    for (double* x : {&p.x, &p.y, &p.z}) {
        if (at_line_end())
            return cursor_.refuse(Errc::syntax, "the line ends; give three coordinates a vertex");
        if (!cursor_.number(*x)) return false;
    }
    mesh_.vertices.push_back(p);
    mesh_.vertex_lines.push_back(line);
    return count();
}

Result<MeshInput3> MeshText::result() {
    if (cursor_.error()) return tl::unexpected(*cursor_.error());
    return std::move(mesh_);
}

}  // namespace sightline::detail
