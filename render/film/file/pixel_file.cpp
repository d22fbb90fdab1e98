#include "render/film/file/pixel_file.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>

#include "render/base/replacing_file.h"
#include "render/film/file/exr_stream.h"
#include "render/film/file/png_encoder.h"

namespace pdr {
namespace {

void encodeExr(ivec2 size, const ValueChannel& channel, const std::vector<Fact>& facts, ExrStream& stream) {
    Imf::Header header(size.x, size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.channels().insert(channel.name, Imf::Channel(Imf::FLOAT));
    Imf::addComments(header, channel.comment + " Not for diagnostic use.");
    insertFacts(header, facts);
    Imf::OutputFile image(stream, header, 0);
    Imf::FrameBuffer frame;
    char* first = const_cast<char*>(reinterpret_cast<const char*>(channel.values.data()));  // it is only read
    frame.insert(channel.name, Imf::Slice(Imf::FLOAT, first, sizeof(float), sizeof(float) * std::size_t(size.x)));
    image.setFrameBuffer(frame);
    image.writePixels(size.y);
}

}  // namespace

Result<void> writePng(ivec2 size, std::vector<std::uint8_t>& rgba, const std::vector<Fact>& facts,
                      const std::filesystem::path& path) {
    Result<ReplacingFile> file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    std::vector<Fact> all = facts;
    all.push_back({"Comment", "Not for diagnostic use."});
    if (!encodePng(size, rgba, std::move(all), *file))
        return Error{phrase("the image could not be encoded as PNG"), path.string(), phrase("Try OpenEXR (.exr).")};
    return file->commit();
}

Result<void> writeExr(ivec2 size, const ValueChannel& channel, const std::vector<Fact>& facts,
                      const std::filesystem::path& path) {
    Result<ReplacingFile> file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    try {
        ExrStream stream(*file, path.string());
        encodeExr(size, channel, facts, stream);
    } catch (const std::exception& failure) {
        if (Result<void> state = file->state(); !state)  // the file has the reason why it could not be written
            return state.error();
        return Error{phrase("the image could not be encoded as OpenEXR (%1)", std::string(failure.what())),
                     path.string(), ""};
    }
    return file->commit();
}

}  // namespace pdr
