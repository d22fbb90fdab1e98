#pragma once
/// What the name of a file says of its format.

#include <filesystem>
#include <string>

namespace pdr {

/// ".png" of "head.PNG": the ending in small letters (a to z); empty where there is none.
inline std::string fileEnding(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& letter : ending)
        if (letter >= 'A' && letter <= 'Z')
            letter = char(letter - 'A' + 'a');
    return ending;
}

}  // namespace pdr
