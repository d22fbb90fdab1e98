#include "app/wire/payload.h"

#include <QByteArrayView>
#include <algorithm>
#include <cstring>
#include <utility>

#include "app/wire/packed_sums.h"

namespace pdr::wire {

namespace {

const char* unpack(std::vector<PixelSums>& sums, const Tile& tile, const Bytes& packed) {
    auto unpacked = unpackSums(packed, std::size_t(tile.width) * std::size_t(tile.height));
    if (!unpacked)
        return "sums of pixels that cannot be unpacked";
    sums = *std::move(unpacked);
    return nullptr;
}

}  // namespace

Bytes takePayload(SceneOrder& order) {
    const auto bytes = std::as_bytes(std::span(order.text));
    return {bytes.begin(), bytes.end()};
}

Bytes takePayload(Chunk& chunk) {
    return std::exchange(chunk.packed, {});
}

Bytes takePayload(Lease& lease) {
    return packSums(lease.before);
}

Bytes takePayload(Result& result) {
    return packSums(result.sums);
}

const char* givePayload(SceneOrder& order, const Bytes& payload) {
    if (!QByteArrayView(payload.data(), qsizetype(payload.size())).isValidUtf8())
        return "its text is no UTF-8";
    order.text.assign(reinterpret_cast<const char*>(payload.data()), payload.size());
    return nullptr;
}

const char* givePayload(Chunk& chunk, Bytes payload) {
    chunk.packed = std::move(payload);
    return chunk.packed.empty() ? "it is empty" : nullptr;
}

const char* givePayload(Lease& lease, const Bytes& payload) {
    if (payload.empty())
        return nullptr;
    if (lease.samples.first % kSamplesPerBlock == 0)
        return "sums of samples before the first one of a block";
    return unpack(lease.before, lease.tile, payload);
}

const char* givePayload(Result& result, const Bytes& payload) {
    return unpack(result.sums, result.tile, payload);
}

}  // namespace pdr::wire
