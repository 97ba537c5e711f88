// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace sightline::experiments {

/// Rows of text under named columns: printed while they come, written as CSV when all are there.
class Table {
public:
    explicit Table(std::vector<std::string> columns);

    /// Appends a row (as many cells as columns, none with a comma) and prints it, aligned, to standard output.
    void add(std::vector<std::string> row);
    [[nodiscard]] std::size_t row_count() const noexcept { return rows_.size(); }
    /// `head` goes first, then one line for the columns and one a row. Fails by exception.
    void write_csv(const std::string& path, const std::string& head) const;

private:
    void print(const std::vector<std::string>& row);

    std::vector<std::string> columns_;
    std::vector<std::size_t> widths_;
    std::vector<std::vector<std::string>> rows_;
};

}  // namespace sightline::experiments
