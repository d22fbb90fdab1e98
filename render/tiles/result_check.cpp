#include "render/tiles/result_check.h"

namespace pdr {
namespace {

bool isPossible(const FaultCount& fault, const Portion& portion, int imageWidth) {
    if (fault.count == 0)
        return true;
    const Tile& tile = portion.tile;
    const int x = int(fault.pixel % std::uint32_t(imageWidth)), y = int(fault.pixel / std::uint32_t(imageWidth));
    const bool inTile = x >= tile.x && x < tile.x + tile.width && y >= tile.y && y < tile.y + tile.height;
    const bool inSamples = fault.sample >= portion.samples.first && fault.sample < portion.samples.end();
    return inTile && inSamples && double(fault.count) <= workOf(tile, portion.samples);
}

bool sameFault(const FaultCount& a, const FaultCount& b) {
    return a.count == b.count && (a.count == 0 || (a.sample == b.sample && a.pixel == b.pixel));
}

bool sameNumbers(const LeaseResult& a, const LeaseResult& b) {
    return sameBits(a.sums, b.sums) && sameBits(a.moments, b.moments);
}

/// Whether a result with the faults `whole` may have a part with the faults `part`.
bool contains(const Health& whole, const Health& part) {
    for (int i = 0; i < kFaults; ++i)
        if (part.faults[i].count > whole.faults[i].count)
            return false;
    return true;
}

}  // namespace

std::string whatIsImpossible(const LeaseResult& result, const Portion& portion, int imageWidth) {
    if (result.tile != portion.tile || result.samples != portion.samples)
        return "it sent a tile that it was not asked for";
    for (const FaultCount& fault : result.health.faults)
        if (!isPossible(fault, portion, imageWidth))
            return "it told of faults that the samples it was asked for cannot have";
    return {};
}

bool sameHealth(const Health& a, const Health& b) {
    for (int i = 0; i < kFaults; ++i)
        if (!sameFault(a.faults[i], b.faults[i]))
            return false;
    return true;
}

bool confirms(const LeaseResult& found, const Audit& audit) {
    const LeaseResult& claimed = audit.claimed;
    const bool sameFaults =
        audit.isWithheld ? sameHealth(found.health, claimed.health) : contains(claimed.health, found.health);
    return sameFaults && sameNumbers(claimed, found);
}

bool isSame(const LeaseResult& a, const LeaseResult& b) {
    return sameHealth(a.health, b.health) && sameNumbers(a, b);
}

}  // namespace pdr
