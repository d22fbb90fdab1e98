#include "dicom/jpeg_size.h"

namespace pdr::dicom {

namespace {

/// SOF0..SOF15 without DHT, JPG and DAC, which share their range; SOF55 is JPEG-LS.
bool isFrameHeader(std::uint8_t marker) {
    const bool inRange = marker >= 0xC0 && marker <= 0xCF;
    return marker == 0xF7 || (inRange && marker != 0xC4 && marker != 0xC8 && marker != 0xCC);
}

/// SOI, TEM and the restart markers stand without a length.
bool standsAlone(std::uint8_t marker) {
    return marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8);
}

}  // namespace

std::optional<ivec2> jpegSize(std::span<const std::uint8_t> stream) {
    const auto word = [&](std::size_t at) { return int(stream[at]) << 8 | int(stream[at + 1]); };
    std::size_t at = 0;
    while (at + 4 <= stream.size() && stream[at] == 0xFF) {
        const std::uint8_t marker = stream[at + 1];
        if (marker == 0xFF) {
            ++at;  // fill bytes may stand before a marker
        } else if (standsAlone(marker)) {
            at += 2;
        } else if (isFrameHeader(marker)) {
            return at + 9 <= stream.size() ? std::optional(ivec2(word(at + 7), word(at + 5))) : std::nullopt;
        } else {
            at += 2 + std::size_t(word(at + 2));
        }
    }
    return {};
}

}  // namespace pdr::dicom
