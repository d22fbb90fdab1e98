#pragma once
/// Small volume files for tests, written by hand: one grid of int16 in three formats, of which each test changes what
/// it is about.

#include <glm/gtc/matrix_transform.hpp>

#include <bit>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "render/volume/volume.h"

namespace pdr::test {

/// Returns values of `size` voxels that all differ, from -1000 on in steps of 10, x fastest; size: at most 300 voxels.
inline std::vector<std::int16_t> steppedValues(ivec3 size) {
    std::vector<std::int16_t> values(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::int16_t(-1000 + 10 * int(i % 300));
    return values;
}

template <class Value>
std::string bytesOf(const std::vector<Value>& values) {
    std::string bytes(values.size() * sizeof(Value), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

inline std::filesystem::path written(const std::filesystem::path& file, const std::string& bytes) {
    std::ofstream(file, std::ios::binary) << bytes;
    return file;
}

/// A NIfTI-1 file. Its sform turns voxels into RAS [mm].
struct NiftiBytes {
    ivec3 size{6, 5, 8};
    dmat4 sform = glm::scale(dmat4(1.0), dvec3(-0.8, -0.9, 1.5));
    std::string bytes = std::string(352, '\0');

    NiftiBytes() { bytes += bytesOf(steppedValues(size)), stateAll(); }

    template <class T>
    void set(std::size_t at, T value) {
        std::memcpy(bytes.data() + at, &value, sizeof value);
    }
    void stateAll() {
        set(0, std::int32_t(348));
        for (int axis = 0; axis < 8; ++axis)
            set(40 + 2 * std::size_t(axis), std::int16_t(axis == 0 ? 3 : axis <= 3 ? size[axis - 1] : 1));
        set(70, std::int16_t(4));   // int16
        set(72, std::int16_t(16));  // its bits
        set(108, 352.0f);
        bytes[123] = 2;  // mm
        set(254, std::int16_t(1));
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                set(280 + 4 * std::size_t(4 * row + column), float(sform[column][row]));
        std::memcpy(bytes.data() + 344, "n+1", 4);
    }
};

/// Returns the header and samples of an NRRD file; `changed` replaces or adds lines "field: value", and an empty value
/// takes one away.
inline std::string nrrdBytes(std::vector<std::pair<std::string, std::string>> changed = {}) {
    std::vector<std::pair<std::string, std::string>> lines{{"type", "short"},
                                                           {"dimension", "3"},
                                                           {"space", "left-posterior-superior"},
                                                           {"sizes", "6 5 8"},
                                                           {"space directions", "(0.8,0,0) (0,0.9,0) (0,0,1.5)"},
                                                           {"endian", "little"},
                                                           {"encoding", "raw"},
                                                           {"space origin", "(-10,-20,30)"}};
    for (const auto& [field, value] : changed) {
        std::erase_if(lines, [&field = field](const auto& line) { return line.first == field; });
        if (!value.empty())
            lines.emplace_back(field, value);
    }
    std::string text = "NRRD0004\n# a comment\n";
    for (const auto& [field, value] : lines)
        text += field + ": " + value + "\n";
    return text + "\n" + bytesOf(steppedValues({6, 5, 8}));
}

/// Returns the header and samples of a MetaImage file, changed likewise.
inline std::string metaImageBytes(std::vector<std::pair<std::string, std::string>> changed = {}) {
    std::vector<std::pair<std::string, std::string>> lines{
        {"ObjectType", "Image"},     {"NDims", "3"},
        {"BinaryData", "True"},      {"BinaryDataByteOrderMSB", "False"},
        {"CompressedData", "False"}, {"TransformMatrix", "1 0 0 0 1 0 0 0 1"},
        {"Offset", "-10 -20 30"},    {"ElementSpacing", "0.8 0.9 1.5"},
        {"DimSize", "6 5 8"},        {"ElementType", "MET_SHORT"}};
    std::string data = "LOCAL";
    for (const auto& [key, value] : changed) {
        std::erase_if(lines, [&key = key](const auto& line) { return line.first == key; });
        if (key == "ElementDataFile")
            data = value;
        else if (!value.empty())
            lines.emplace_back(key, value);
    }
    std::string text;
    for (const auto& [key, value] : lines)
        text += key + " = " + value + "\n";
    return text + "ElementDataFile = " + data + "\n" + bytesOf(steppedValues({6, 5, 8}));
}

}  // namespace pdr::test
