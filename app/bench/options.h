#pragma once
/// Parsed command line: files in their order, and options by name.

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pdr::bench {

struct Options {
    std::vector<std::string> files;
    std::map<std::string, std::string> named;  ///< "--samples" -> "64"

    /// Parses `words`. Returns null for a name that is not `known` or that lacks its value. `flags`: names without a
    /// value.
    static std::optional<Options> read(const std::vector<std::string>& words, const std::set<std::string>& known,
                                       const std::set<std::string>& flags = {}) {
        Options options;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (!words[i].starts_with("--")) {
                options.files.push_back(words[i]);
                continue;
            }
            if (flags.contains(words[i])) {
                options.named[words[i]] = "";
                continue;
            }
            if (!known.contains(words[i]) || i + 1 == words.size())
                return std::nullopt;
            options.named[words[i]] = words[i + 1];
            ++i;
        }
        return options;
    }

    /// Returns the word after `name`, or `otherwise` if it is not given.
    std::string word(const std::string& name, const std::string& otherwise) const {
        const auto found = named.find(name);
        return found == named.end() ? otherwise : found->second;
    }

    /// Returns a whole number of at least `least`, `otherwise` if it is not given, or null if it is something else.
    std::optional<int> number(const std::string& name, int otherwise, int least) const {
        const auto found = named.find(name);
        if (found == named.end())
            return otherwise;
        int value = 0;
        const char* end = found->second.data() + found->second.size();
        const auto [stop, error] = std::from_chars(found->second.data(), end, value);
        if (error != std::errc() || stop != end || value < least)
            return std::nullopt;
        return value;
    }

    /// Returns a finite number above 0, `otherwise` if it is not given, or null if it is something else.
    std::optional<double> positive(const std::string& name, double otherwise) const {
        const auto found = named.find(name);
        if (found == named.end())
            return otherwise;
        double value = 0;
        const char* end = found->second.data() + found->second.size();
        const auto [stop, error] = std::from_chars(found->second.data(), end, value);
        if (error != std::errc() || stop != end || !(value > 0) || !std::isfinite(value))
            return std::nullopt;
        return value;
    }
};

}  // namespace pdr::bench
