// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/table.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "sightline/scene/result.hpp"

namespace sightline::experiments {

Table::Table(std::vector<std::string> columns) : columns_(std::move(columns)) {
    for (const std::string& name : columns_)
        widths_.push_back(std::max<std::size_t>(name.size(), 6));
}

void Table::print(const std::vector<std::string>& row) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
        widths_[i] = std::max(widths_[i], row[i].size());
        const std::string gap(widths_[i] - row[i].size(), ' ');
        line +=
            i == 0 ? row[i] + gap : "  " + gap + row[i];  // names to the left, numbers to the right
    }
    std::puts(line.c_str());
    std::fflush(stdout);
}

void Table::add(std::vector<std::string> row) {
    SIGHTLINE_EXPECT(row.size() == columns_.size());
    for (const std::string& cell : row) SIGHTLINE_EXPECT(cell.find(',') == std::string::npos);
    if (rows_.empty()) {
        widths_[0] = std::max<std::size_t>(widths_[0], 24);
        print(columns_);
    }
    print(row);
    rows_.push_back(std::move(row));
}

void Table::write_csv(const std::string& path, const std::string& head) const {
    std::ofstream out(path);
    out << head;
    const auto write = [&](const std::vector<std::string>& row) {
        for (std::size_t i = 0; i < row.size(); ++i) out << (i == 0 ? "" : ",") << row[i];
        out << '\n';
    };
    write(columns_);
    for (const auto& row : rows_) write(row);
    if (!out.flush()) throw std::runtime_error("cannot write " + path);
}

}  // namespace sightline::experiments
