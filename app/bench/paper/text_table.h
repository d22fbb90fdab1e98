#pragma once
/// Tables that are read on a terminal and are Markdown too; and numbers for them.

#include <optional>
#include <string>
#include <vector>

namespace pdr::bench::paper {

class TextTable {
  public:
    /// `words`: so many columns, the first ones, are set to the left, the others to the right.
    explicit TextTable(std::vector<std::string> head, std::size_t words = 1) : words_(words), rows_{std::move(head)} {}

    /// As many cells as the head has.
    void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
    /// Each line ends with a line break.
    std::string text() const;

  private:
    std::size_t words_;
    std::vector<std::vector<std::string>> rows_;
};

/// Four significant digits, never an exponent: "0.1079", "10.79", "2498"; "-" for nothing.
std::string digits(std::optional<double> value);
/// As short as it can be said: "3", "0.05".
std::string plain(double value);
/// Three digits after the point, four where it is nearly 1: "0.723", "0.9990".
std::string fraction(std::optional<double> value);
/// "98 %"
std::string percent(std::optional<double> value);
/// Seconds as milliseconds, digits().
std::string milliseconds(std::optional<double> seconds);

}  // namespace pdr::bench::paper
