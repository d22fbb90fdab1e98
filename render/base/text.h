#pragma once
/// Texts for the user. Modules write them in English, and ui/ translates them.

#include <concepts>
#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace pdr {

/// A sentence or phrase for the user: an English string, and the parts that it consists of. Its pattern identifies it:
/// the pattern is written once, where the sentence is made, and translated in resources/translations.
///   pattern    a literal in which %1 to %9 stand for the arguments: "%1 and %2 are %3 mm apart"
///   words      names of files, messages of other libraries: the same in every language
///   number     digits with a decimal point, which ui/ formats for the language
///   sentence   its one argument, with a capital in front and a full stop behind
class Text : public std::string {
  public:
    enum class Kind { words, pattern, number, sentence };

    Text() = default;
    /// Creates a pattern without arguments from a literal.
    Text(const char* pattern) : std::string(pattern), kind_(Kind::pattern), pattern_(pattern) {}
    Text(std::string words) : std::string(std::move(words)) {}
    template <std::integral Integer>
    Text(Integer number) : std::string(std::to_string(number)), kind_(Kind::number) {}
    Text(const char* pattern, std::vector<Text> arguments);

    /// Returns a number. `digits`: "0.75".
    static Text number(std::string digits);
    /// Returns `phrase` with a capital in front, unless it starts with a name, and a full stop behind. Empty stays
    /// empty.
    static Text sentence(const Text& phrase);

    Kind kind() const { return kind_; }
    const std::string& pattern() const { return pattern_; }
    const std::vector<Text>& arguments() const { return arguments_; }

    /// Deleted: appended text would have no part that can be translated.
    void operator+=(const std::string&) = delete;

  private:
    Kind kind_ = Kind::words;
    std::string pattern_;
    std::vector<Text> arguments_;
};

/// Returns `pattern` with its arguments in place: texts, strings, whole numbers.
template <typename... Arguments>
Text phrase(const char* pattern, Arguments&&... arguments) {
    return Text(pattern, std::vector<Text>{Text(std::forward<Arguments>(arguments))...});
}

/// Returns `value` with `digits` significant digits: "0.75", "1e+06".
Text numberOf(double value, int digits = 6);
/// Returns `value` with `decimals` digits behind the decimal point: "6.0".
Text fixedNumber(double value, int decimals);

/// Returns the names with commas in between: "bones, lungs".
std::string listed(const std::set<std::string, std::less<>>& names);

/// Returns `a` and `b` with a space in between; either may be empty.
Text joined(const Text& a, const Text& b);

}  // namespace pdr
