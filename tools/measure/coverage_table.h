#pragma once
/// A table of what stated_coverage found: the lowest, the median and the highest line of each column and number of
/// samples.

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "tools/measure/slack.h"

namespace pdr::test {

/// Returns the cells of a line.
inline std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream all(line);
    for (std::string cell; std::getline(all, cell, ',');)
        cells.push_back(cell);
    return cells;
}

/// Returns the values of the column `name` in the lines of `samples`, without empty cells.
inline std::vector<double> columnOf(const std::string& file, const std::string& name, std::uint64_t samples) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    const std::vector<std::string> names = cellsOf(line);
    const auto column = std::size_t(std::ranges::find(names, name) - names.begin());
    const auto count = std::size_t(std::ranges::find(names, "samples") - names.begin());
    std::vector<double> values;
    while (std::getline(in, line)) {
        const std::vector<std::string> cells = cellsOf(line);
        if (column < cells.size() && !cells[column].empty() && cells[count] == std::to_string(samples))
            values.push_back(std::stod(cells[column]));
    }
    return values;
}

inline void printCoverage(const std::string& file, std::span<const std::uint64_t> samples) {
    std::printf("lowest / median / highest line (number of lines)\n");
    for (const char* name : {"sentence", "denoised", "at_most", "map", "denoised_map", "error", "slack"})
        for (const std::uint64_t n : samples)
            if (const std::vector<double> values = columnOf(file, name, n); !values.empty())
                std::printf("%-12s %4d samples  %6.2f / %6.2f / %6.2f (%d)\n", name, int(n), quantile(values, 0),
                            quantile(values, 0.5), quantile(values, 1), int(values.size()));
}

}  // namespace pdr::test
