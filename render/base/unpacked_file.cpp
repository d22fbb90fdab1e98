#include "render/base/unpacked_file.h"

#include <zlib.h>

#include <algorithm>
#include <array>

#include "render/base/plain_file.h"

namespace pdr {

struct UnpackedFile::Stream {
    z_stream state{};
    std::array<std::uint8_t, 32 << 10> packed{};
    bool hasEnded = false;

    Stream() {
        constexpr int kGzipOrZlib = 32;
        if (inflateInit2(&state, MAX_WBITS + kGzipOrZlib) != Z_OK)
            throw std::bad_alloc();
    }
    ~Stream() { inflateEnd(&state); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    /// Returns whether another gzip stream follows: what `cat a.gz b.gz` writes is one file.
    bool goesOn() const { return state.avail_in > 0 && *state.next_in == 0x1f; }
};

UnpackedFile::UnpackedFile(const NamedBytes& file, std::uint64_t start, bool isPacked)
    : bytes_(file), opened_(file.memory ? Result<void>() : checkPlainFile(file.name)) {
    if (!opened_)
        return;
    if (!bytes_.memory)
        file_.open(bytes_.name, std::ios::binary);
    skipStored(start);
    if (isPacked)
        stream_ = std::make_unique<Stream>();
}

UnpackedFile::~UnpackedFile() = default;

Error UnpackedFile::refused(const Text& what) const {
    return {what, bytes_.name.string(), phrase("Copy the file again."), ErrorKind::refused};
}

/// Reads bytes as they are stored; returns their number, 0 at the end.
std::size_t UnpackedFile::readStored(std::span<std::uint8_t> out) {
    if (!bytes_.memory) {
        file_.read(reinterpret_cast<char*>(out.data()), std::streamsize(out.size()));
        return std::size_t(file_.gcount());
    }
    const std::span<const std::uint8_t> rest = std::span(*bytes_.memory).subspan(at_);
    const std::size_t count = std::min(out.size(), rest.size());
    std::copy_n(rest.begin(), count, out.begin());
    at_ += count;
    return count;
}

void UnpackedFile::skipStored(std::uint64_t count) {
    if (bytes_.memory)
        at_ += std::size_t(std::min<std::uint64_t>(count, bytes_.memory->size() - at_));
    else
        file_.seekg(std::streamoff(count), std::ios::cur);
}

Result<std::size_t> UnpackedFile::readSome(std::span<std::uint8_t> out) {
    if (!opened_)
        return opened_.error();
    if (stream_)
        return inflateSome(out);
    return readStored(out);
}

Result<void> UnpackedFile::read(std::span<std::uint8_t> out) {
    while (!out.empty()) {
        const Result<std::size_t> count = readSome(out);
        if (!count)
            return count.error();
        if (*count == 0)
            return refused(phrase("the file ends too early"));
        out = out.subspan(*count);
    }
    return {};
}

Result<void> UnpackedFile::skip(std::uint64_t count) {
    if (!stream_ && opened_) {
        skipStored(count);
        return {};
    }
    std::array<std::uint8_t, 4096> left;
    for (std::uint64_t piece; count > 0; count -= piece) {
        piece = std::min<std::uint64_t>(count, left.size());
        if (Result<void> ok = read(std::span(left).first(piece)); !ok)
            return ok;
    }
    return {};
}

Result<void> UnpackedFile::checkEnd(std::uint64_t most) {
    std::array<std::uint8_t, 4096> surplus;
    for (std::uint64_t seen = 0; stream_ && !stream_->hasEnded && seen <= most;) {
        const Result<std::size_t> count = readSome(surplus);
        if (!count)
            return count.error();
        seen += *count;
    }
    return opened_;
}

/// Returns the number of bytes that were unpacked, 0 at the end of the stream.
Result<std::size_t> UnpackedFile::inflateSome(std::span<std::uint8_t> out) {
    constexpr std::size_t kMost = 1 << 30;
    z_stream& state = stream_->state;
    const std::size_t wanted = std::min(out.size(), kMost);
    state.next_out = out.data();
    state.avail_out = uInt(wanted);
    while (!stream_->hasEnded && state.avail_out == wanted) {
        // Read more packed bytes
        if (state.avail_in == 0) {
            state.next_in = stream_->packed.data();
            state.avail_in = uInt(readStored(stream_->packed));
            if (state.avail_in == 0)
                return refused(phrase("the file ends too early"));
        }
        // Unpack them
        const int made = inflate(&state, Z_NO_FLUSH);
        if (made == Z_STREAM_END && stream_->goesOn())
            inflateReset(&state);
        else if (made == Z_STREAM_END)
            stream_->hasEnded = true;
        else if (made != Z_OK && made != Z_BUF_ERROR)
            return refused(phrase("its packed part is damaged"));
    }
    return wanted - state.avail_out;
}

}  // namespace pdr
