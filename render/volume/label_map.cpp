#include "render/volume/label_map.h"

#include <algorithm>
#include <cmath>

#include "render/base/lower_case.h"
#include "render/volume/sheared.h"

namespace pdr {
namespace {

/// The voxels of one part: their number, and the sum of their indices.
struct PartVoxels {
    std::int64_t count = 0;
    dvec3 indices{0};
};

std::vector<PartVoxels> voxelsOf(const LabelMap& map) {
    std::vector<PartVoxels> parts(map.parts.size() + 1);
    const ivec3 size = map.geometry.size;
    const std::uint8_t* label = map.labels.data();
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x, ++label)
                if (*label != 0) {
                    ++parts[*label].count;
                    parts[*label].indices += dvec3(x, y, z);
                }
    parts.erase(parts.begin());
    return parts;
}

/// Returns a name of a left part as that of its right counterpart, in small letters; empty if it names no left part.
std::string mirroredName(const std::string& name) {
    std::string mirrored = lowerCase(name);
    const std::size_t at = mirrored.find("left");
    return at == std::string::npos ? std::string() : mirrored.replace(at, 4, "right");
}

}  // namespace

std::vector<double> partsMl(const LabelMap& map) {
    const double each = voxelMl(map.geometry);
    std::vector<double> ml;
    for (const PartVoxels& part : voxelsOf(map))
        ml.push_back(double(part.count) * each);
    return ml;
}

Text emptyPartsNote(std::int64_t count) {
    return phrase("parts that have a name and no voxels: %1", count);
}

std::string standardName(std::int64_t number) {
    return "part " + std::to_string(number);
}

LabelColour standardColour(std::int64_t number) {
    constexpr double kGolden = 0.6180339887498949;  // the turn that leaves no two of many hues close together
    const double hue = 6 * (double(number) * kGolden - std::floor(double(number) * kGolden));
    const auto channel = [hue](double at) {
        const double away = std::abs(std::fmod(hue - at + 9, 6.0) - 3);  // sixths of a turn from `at`
        return std::uint8_t(std::lround(90 + 140 * std::clamp(2 - away, 0.0, 1.0)));
    };
    return {channel(0), channel(2), channel(4)};
}

std::optional<CrossedSides> crossedSides(const LabelMap& map) {
    constexpr double kApartMm = 10;
    const std::vector<PartVoxels> voxels = voxelsOf(map);
    const auto leftOf = [&](std::size_t part) {  // patient space has +x to the left
        return (map.geometry.patientFromIndex * dvec4(voxels[part].indices / double(voxels[part].count), 1)).x;
    };
    std::optional<CrossedSides> crossed;
    int balance = 0;
    for (std::size_t left = 0; left < map.parts.size(); ++left) {
        const std::string counterpart = mirroredName(map.parts[left].name);
        for (std::size_t right = 0; right < map.parts.size(); ++right) {
            if (counterpart.empty() || lowerCase(map.parts[right].name) != counterpart || voxels[left].count == 0 ||
                voxels[right].count == 0)
                continue;
            const double apart = leftOf(left) - leftOf(right);
            balance += apart > kApartMm ? 1 : apart < -kApartMm ? -1 : 0;
            if (apart < -kApartMm && !crossed)
                crossed = CrossedSides{map.parts[left].name, map.parts[right].name};
        }
    }
    return balance < 0 ? crossed : std::nullopt;
}

}  // namespace pdr
