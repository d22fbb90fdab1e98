#pragma once
/// Reads the channels of an OpenEXR file, independently of the code that wrote it.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>

#include <filesystem>
#include <string>
#include <vector>

namespace pdr::test {

/// Channels R, G, B of the means, of their standard errors and of upper bounds on these.
inline const std::vector<std::string> kExrChannels{"R",       "G",       "B",       "error.R", "error.G",
                                                   "error.B", "bound.R", "bound.G", "bound.B"};

/// Returns all of kExrChannels, pixel by pixel, row by row from the top; empty if one is missing.
inline std::vector<float> exrValues(const std::filesystem::path& path) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    const std::size_t width = std::size_t(box.max.x + 1), height = std::size_t(box.max.y + 1);
    const std::size_t bytes = kExrChannels.size() * sizeof(float);
    std::vector<float> values(width * height * kExrChannels.size());
    Imf::FrameBuffer frame;
    float* next = values.data();
    for (const std::string& channel : kExrChannels) {
        if (file.header().channels().findChannel(channel) == nullptr)
            return {};
        frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(next++), bytes, bytes * width));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, box.max.y);
    return values;
}

/// Returns the channel of that name, row by row from the top; empty if there is none, or if it is not the only one.
inline std::vector<float> exrChannel(const std::filesystem::path& path, const std::string& name) {
    Imf::InputFile file(path.c_str());
    const Imath::Box2i box = file.header().dataWindow();
    const Imf::ChannelList& channels = file.header().channels();
    if (channels.findChannel(name) == nullptr || ++channels.begin() != channels.end())
        return {};
    const std::size_t width = std::size_t(box.max.x + 1), height = std::size_t(box.max.y + 1);
    std::vector<float> values(width * height);
    Imf::FrameBuffer frame;
    frame.insert(name,
                 Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float), sizeof(float) * width));
    file.setFrameBuffer(frame);
    file.readPixels(0, box.max.y);
    return values;
}

}  // namespace pdr::test
