#include "app/node/introduction.h"

#include <random>

#include "app/coordinator/node_connection.h"
#include "app/coordinator/reference_bits.h"
#include "app/node/kept_sums.h"
#include "render/base/free_memory.h"
#include "render/base/version.h"
#include "render/tiles/reference_tiles.h"

namespace pdr::node {

Result<wire::Hello> introduction(const NodeOptions& options, Device& device, const std::optional<Error>& instead) {
    const Result<std::vector<std::byte>> tiles = referenceTiles(device);
    if (!tiles)
        return tiles.error();
    wire::Hello hello;
    std::random_device random;
    hello.program = "pdrender-node " PDR_VERSION;
    hello.name = options.name.toStdString();
    hello.boot = nodes::newNonce(random);
    hello.bits = nodes::bitsOf(*tiles);
    hello.memoryBytes = freeBytes();
    hello.keptPixels = KeptSums::kMostPixels;
    nameDevice(hello, device.info(), instead);
    return hello;
}

void nameDevice(wire::Hello& hello, const DeviceInfo& device, const std::optional<Error>& instead) {
    hello.device = device.name;
    hello.details = device.details;
    if (instead)
        hello.details += "; no GPU: " + instead->what;
}

}  // namespace pdr::node
