#pragma once
/// Bytes as zlib packs them, for tests that need packed files.

#include <zlib.h>

#include <string>

namespace pdr::test {

/// Values of `windowBits` (zlib's manual, deflateInit2): a bare stream, as DICOM has it, or a gzip file.
inline constexpr int kBareStream = -MAX_WBITS, kGzipFile = MAX_WBITS + 16;

inline std::string deflated(const std::string& bytes, int windowBits) {
    z_stream stream{};
    deflateInit2(&stream, 9, Z_DEFLATED, windowBits, 9, Z_DEFAULT_STRATEGY);
    std::string out(deflateBound(&stream, uLong(bytes.size())), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = uInt(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = uInt(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

}  // namespace pdr::test
