#include "render/volume/file/label_nrrd.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <new>
#include <sstream>

#include "render/base/file_ending.h"
#include "render/base/replacing_file.h"

namespace pdr {
namespace {

std::string vectorText(const dvec4& vector) {
    std::ostringstream text;
    text.precision(17);
    text << '(' << vector.x << ',' << vector.y << ',' << vector.z << ')';
    return text.str();
}

/// Returns `name` on one line.
std::string onOneLine(std::string name) {
    std::ranges::replace_if(
        name, [](unsigned char c) { return c < ' '; }, ' ');
    return name;
}

std::string headerOf(const LabelMap& map) {
    const ivec3 size = map.geometry.size;
    const dmat4& place = map.geometry.patientFromIndex;
    std::ostringstream text;
    text << "NRRD0004\ntype: unsigned char\ndimension: 3\nspace: left-posterior-superior\n"
         << "sizes: " << size.x << ' ' << size.y << ' ' << size.z << '\n'
         << "space directions: " << vectorText(place[0]) << ' ' << vectorText(place[1]) << ' ' << vectorText(place[2])
         << "\nkinds: domain domain domain\nendian: little\nencoding: gzip\n"
         << "space origin: " << vectorText(place[3]) << '\n';
    for (std::size_t n = 0; n < map.parts.size(); ++n) {
        const MappedPart& part = map.parts[n];
        const auto channel = [&](std::size_t i) { return double(part.colour[i]) / 255; };
        const std::string segment = "Segment" + std::to_string(n) + "_";
        text << segment << "ID:=Segment_" << n + 1 << '\n'
             << segment << "Name:=" << onOneLine(part.name) << '\n'
             << segment << "Color:=" << channel(0) << ' ' << channel(1) << ' ' << channel(2) << '\n'
             << segment << "LabelValue:=" << n + 1 << '\n'
             << segment << "Layer:=0\n";
    }
    text << '\n';
    return text.str();
}

/// Writes bytes packed by gzip.
void writePacked(std::span<const std::uint8_t> bytes, ReplacingFile& file) {
    constexpr int kGzip = 16, kFast = 4, kMemory = 8;
    z_stream stream{};
    if (deflateInit2(&stream, kFast, Z_DEFLATED, MAX_WBITS + kGzip, kMemory, Z_DEFAULT_STRATEGY) != Z_OK)
        throw std::bad_alloc();
    constexpr std::size_t kPiece = 1 << 20;
    std::array<std::uint8_t, 32 << 10> packed;
    for (std::size_t at = 0; at < bytes.size(); at += kPiece) {
        const std::span<const std::uint8_t> piece = bytes.subspan(at, std::min(kPiece, bytes.size() - at));
        stream.next_in = const_cast<Bytef*>(piece.data());
        stream.avail_in = uInt(piece.size());
        const int flush = at + piece.size() == bytes.size() ? Z_FINISH : Z_NO_FLUSH;
        do {
            stream.next_out = packed.data();
            stream.avail_out = uInt(packed.size());
            deflate(&stream, flush);
            file.write(packed.data(), packed.size() - stream.avail_out);
        } while (stream.avail_out == 0);
    }
    deflateEnd(&stream);
}

}  // namespace

bool isLabelFile(const std::filesystem::path& file) {
    return fileEnding(file) == ".nrrd" && fileEnding(file.stem()) == ".seg";
}

Result<void> writeLabelFile(const LabelMap& map, const std::filesystem::path& file) {
    if (!isLabelFile(file))
        return Error{phrase("label maps are written to files that end in %1", kLabelEnding), file.string(), "",
                     ErrorKind::refused};
    Result<ReplacingFile> out = ReplacingFile::open(file, FileAccess::owner);
    if (!out)
        return out.error();
    const std::string header = headerOf(map);
    out->write(header.data(), header.size());
    writePacked(map.labels, *out);
    return out->commit();
}

}  // namespace pdr
