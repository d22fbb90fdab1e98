#pragma once
/// Sentences of rooms that know no language but English, so that ui/ can say them in others.

#include <concepts>
#include <string>
#include <utility>
#include <vector>

namespace pdr {

/// A sentence or phrase for the person at the screen: an English string, and what it was made of. Its pattern is its
/// name: it is written once, where the sentence is made, and translated in resources/translations.
///   pattern    a literal in which %1 to %9 stand for the arguments: "%1 and %2 are %3 mm apart"
///   words      names of files, what other libraries say: the same in every language
///   number     digits with a decimal point, written in ui/ as the language does
///   sentence   its one argument, with a capital in front and a full stop behind
class Text : public std::string {
  public:
    enum class Kind { words, pattern, number, sentence };

    Text() = default;
    /// A literal: a pattern without arguments.
    Text(const char* pattern) : std::string(pattern), kind_(Kind::pattern), pattern_(pattern) {}
    Text(std::string words) : std::string(std::move(words)) {}
    template <std::integral Integer>
    Text(Integer number) : std::string(std::to_string(number)), kind_(Kind::number) {}
    Text(const char* pattern, std::vector<Text> arguments);

    /// `digits`: "0.75".
    static Text number(std::string digits);
    /// `phrase` with a capital in front, unless a name stands there, and a full stop behind. Empty stays empty.
    static Text sentence(const Text& phrase);

    Kind kind() const { return kind_; }
    const std::string& pattern() const { return pattern_; }
    const std::vector<Text>& arguments() const { return arguments_; }

    /// What was made of parts cannot grow beside them.
    void operator+=(const std::string&) = delete;

  private:
    Kind kind_ = Kind::words;
    std::string pattern_;
    std::vector<Text> arguments_;
};

/// `pattern` with its arguments in their places: texts, strings, whole numbers.
template <typename... Arguments>
Text phrase(const char* pattern, Arguments&&... arguments) {
    return Text(pattern, std::vector<Text>{Text(std::forward<Arguments>(arguments))...});
}

/// `value` with so many digits that count: "0.75", "1e+06".
Text numberOf(double value, int digits = 6);
/// `value` with so many digits behind the point: "6.0".
Text fixedNumber(double value, int decimals);

/// One sentence behind the other, a space between; either may be empty.
Text joined(const Text& a, const Text& b);

}  // namespace pdr
