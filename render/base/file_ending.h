#pragma once
/// The ending of a file's name, which states its format.

#include <filesystem>
#include <string>

namespace pdr {

/// Returns the ending of a file's name in lower case (a to z), ".png" for "head.PNG"; empty if there is none.
inline std::string fileEnding(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z')
            letter = char(letter - 'A' + 'a');
    return ending;
}

}  // namespace pdr
