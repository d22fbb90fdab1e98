#pragma once
/// Letters of either case, for words that files may spell in both.

#include <string>

namespace pdr {

/// Returns `text` with A to Z as small letters, whatever the locale; other bytes stay.
inline std::string lowerCase(std::string text) {
    for (char& letter : text)
        if (letter >= 'A' && letter <= 'Z')
            letter = char(letter - 'A' + 'a');
    return text;
}

}  // namespace pdr
