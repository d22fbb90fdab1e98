#pragma once
/// Tables that are readable on a terminal and are Markdown too, and numbers formatted for them.

#include <optional>
#include <string>
#include <vector>

namespace pdr::bench::paper {

class TextTable {
  public:
    /// Makes a table with its head. `words`: number of columns, from the first, that are left-aligned; the others are
    /// right-aligned.
    explicit TextTable(std::vector<std::string> head, std::size_t words = 1) : words_(words), rows_{std::move(head)} {}

    /// Adds a row, with as many cells as the head has.
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    /// Returns the table. Each line ends with a line break.
    std::string text() const;

  private:
    std::size_t words_;
    std::vector<std::vector<std::string>> rows_;
};

/// Returns four significant digits, never an exponent: "0.1079", "10.79", "2498"; "-" for null.
std::string digits(std::optional<double> value);
/// Returns the shortest text, of up to six digits: "3", "0.05".
std::string plain(double value);
/// Returns three digits after the point, four between 0.99 and 1: "0.723", "0.9990".
std::string fraction(std::optional<double> value);
/// Returns a fraction as "98 %".
std::string percent(std::optional<double> value);
/// Returns seconds as milliseconds, formatted by digits().
std::string milliseconds(std::optional<double> seconds);

}  // namespace pdr::bench::paper
