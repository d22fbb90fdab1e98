#include "app/wire/payload.h"

#include <QByteArrayView>
#include <algorithm>
#include <cstring>
#include <utility>

#include "app/wire/packed_sums.h"

namespace pdr::wire {

namespace {

/// Takes the pixels of `tile` from the front of `packed`. Returns what is wrong; null: nothing.
template <class Pixel>
const char* take(std::vector<Pixel>& pixels, const Tile& tile, std::span<const std::byte>& packed) {
    auto unpacked = unpack<Pixel>(packed, pixelCount(tile));
    if (!unpacked)
        return "sums of pixels that cannot be unpacked";
    pixels = *std::move(unpacked);
    return nullptr;
}

const char* lookForMore(std::span<const std::byte> packed) {
    return packed.empty() ? nullptr : "sums of pixels that cannot be unpacked";
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
    Bytes packed;
    pack(lease.before, packed);
    pack(lease.moments, packed);
    return packed;
}

Bytes takePayload(Result& result) {
    Bytes packed;
    pack(result.sums, packed);
    pack(result.moments, packed);
    return packed;
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
    if (lease.kept)
        return "sums that were not to be sent";
    if (lease.samples.first == 0 || (!isDeep(lease.samples) && lease.samples.first % kSamplesPerBlock == 0))
        return "sums of samples before the first one of a block";
    std::span<const std::byte> packed(payload);
    const char* wrong =
        isDeep(lease.samples) ? take(lease.moments, lease.tile, packed) : take(lease.before, lease.tile, packed);
    return wrong != nullptr ? wrong : lookForMore(packed);
}

const char* givePayload(Result& result, const Bytes& payload) {
    std::span<const std::byte> packed(payload);
    const char* wrong = take(result.sums, result.tile, packed);
    if (wrong == nullptr && isDeep(result.samples))
        wrong = take(result.moments, result.tile, packed);
    return wrong != nullptr ? wrong : lookForMore(packed);
}

}  // namespace pdr::wire
