#include "dicom/read/byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "render/base/plain_file.h"

namespace pdr::dicom {

namespace {

constexpr std::size_t kWindowBytes = 16 << 10;
constexpr std::size_t kAskEvery = 1 << 20;

}  // namespace

ByteSource::ByteSource(const NamedBytes& object) : memory_(object.memory) {
    if (memory_) {
        window_ = *memory_;
        size_ = window_.size();
        return;
    }
    opened_ = checkPlainFile(object.name);
    if (!opened_)
        return;
    std::error_code failure;
    size_ = std::filesystem::file_size(object.name, failure);
    file_.open(object.name, std::ios::binary);
    if (file_.is_open() && !failure)
        return;
    opened_ = Error{phrase("the file cannot be read"), object.name.string(), ""};
    size_ = 0;
}

ByteSource::ByteSource(std::vector<std::uint8_t> bytes)
    : ByteSource(NamedBytes{{}, std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes))}) {}

std::size_t ByteSource::readFile(std::uint64_t offset, std::span<std::uint8_t> out) {
    file_.clear();
    file_.seekg(std::streamoff(offset));
    file_.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size()));
    return file_.bad() ? 0 : std::size_t(file_.gcount());
}

bool ByteSource::fillWindow(std::uint64_t offset) {
    buffer_.resize(std::size_t(std::min<std::uint64_t>(kWindowBytes, size_ - offset)));
    windowStart_ = offset;
    window_ = std::span(buffer_).first(readFile(offset, buffer_));
    return !window_.empty();
}

bool ByteSource::read(std::uint64_t offset, std::span<std::uint8_t> out) {
    if (!memory_ && out.size() > kWindowBytes)
        return offset < size_ && out.size() <= size_ - offset && readFile(offset, out) == out.size();
    while (!out.empty()) {
        if (offset >= size_ || out.size() > size_ - offset)
            return false;
        const bool inside = offset >= windowStart_ && offset < windowStart_ + window_.size();
        if (!inside && !fillWindow(offset))
            return false;
        const std::size_t skip = std::size_t(offset - windowStart_);
        const std::size_t count = std::min(out.size(), window_.size() - skip);
        std::memcpy(out.data(), window_.data() + skip, count);
        out = out.subspan(count);
        offset += count;
    }
    return true;
}

namespace {

/// Inflates everything from `offset` on and passes it to `take` piece by piece. False if the stream is damaged or
/// longer than `limit`, or `goOn` returned false.
template <class Take>
bool inflateEach(ByteSource& source, std::uint64_t offset, std::size_t limit, const GoOn& goOn, Take take) {
    z_stream stream{};
    if (inflateInit2(&stream, -MAX_WBITS) != Z_OK)
        return false;
    std::array<std::uint8_t, kWindowBytes> packed, unpacked;
    int state = Z_OK;
    std::size_t total = 0, asked = 0;
    while (state == Z_OK && total <= limit) {
        // Read more packed bytes
        if (stream.avail_in == 0) {
            const auto left = offset < source.size() ? source.size() - offset : 0;
            const auto count = std::size_t(std::min<std::uint64_t>(packed.size(), left));
            if (count == 0 || !source.read(offset, std::span(packed).first(count)))
                break;
            offset += count;
            stream.next_in = packed.data();
            stream.avail_in = uInt(count);
        }
        // Inflate them, and pass on the result
        stream.next_out = unpacked.data();
        stream.avail_out = uInt(unpacked.size());
        state = inflate(&stream, Z_NO_FLUSH);
        const std::size_t made = unpacked.size() - stream.avail_out;
        take(std::span<const std::uint8_t>(unpacked).first(made));
        total += made;
        if (total - asked >= kAskEvery && !goOn())
            break;
        asked = total - asked >= kAskEvery ? total : asked;
    }
    inflateEnd(&stream);
    return state == Z_STREAM_END && total <= limit;
}

}  // namespace

std::vector<std::uint8_t> inflateFrom(ByteSource& source, std::uint64_t offset, std::size_t limit, const GoOn& goOn) {
    using Piece = std::span<const std::uint8_t>;
    std::vector<std::uint8_t> inflated;
    std::size_t total = 0;
    if (!inflateEach(source, offset, limit, goOn, [&](Piece piece) { total += piece.size(); }))
        return inflated;
    inflated.reserve(total);
    const auto keep = [&](Piece piece) { inflated.insert(inflated.end(), piece.begin(), piece.end()); };
    if (!inflateEach(source, offset, limit, goOn, keep))
        inflated = {};
    return inflated;
}

}  // namespace pdr::dicom
