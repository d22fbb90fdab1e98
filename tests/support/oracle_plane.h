#pragma once
/// Planes as the scripts of tests/oracle write them.

#include <nlohmann/json.hpp>

#include "render/slice/slice_plane.h"

namespace pdr::test {

inline SlicePlane planeOf(const nlohmann::json& written) {
    const auto vector = [&](const char* name) {
        const nlohmann::json& numbers = written.at(name);
        return dvec3(numbers.at(0), numbers.at(1), numbers.at(2));
    };
    return {vector("originMm"), vector("right"), vector("down"), written.at("mmPerPixel"),
            ivec2(written.at("size").at(0), written.at("size").at(1))};
}

}  // namespace pdr::test
