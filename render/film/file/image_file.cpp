#include "render/film/file/image_file.h"

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "render/base/errors.h"
#include "render/base/image_size.h"
#include "render/base/plain_file.h"
#include "render/base/replacing_file.h"
#include "render/film/display/denoised_view.h"
#include "render/film/display/tone_map.h"
#include "render/film/error/likely_error.h"
#include "render/film/error/local_error.h"
#include "render/film/file/exr_stream.h"
#include "render/film/file/png_encoder.h"
#include "render/film/levels_text.h"

namespace pdr {
namespace {

std::string errorFact(const std::optional<DenoisedError>& error) {
    if (!error)
        return "error not known";
    return "95 % of the tissue within " + levelsText(error->levelsAtMost) + " of 255 levels; lines of 2 pixels below " +
           std::to_string(int(std::ceil(100 * std::min(error->hiddenContrast, 1.0)))) + " % contrast may be missing";
}

std::string denoisedFact(const std::optional<DenoisedError>& error, std::size_t lostLines) {
    if (lostLines == 0)
        return errorFact(error);
    const std::string count = (lostLines >= denoise::kMostLostLines ? "at least " : "") + std::to_string(lostLines);
    return errorFact(error) + "; " + count + (lostLines == 1 ? " line" : " lines") + " of the film missing";
}

/// Commits the file unless a stop was requested; a file that is not committed leaves nothing behind.
Result<void> commitUnlessStopped(ReplacingFile& file, const std::stop_token& stop) {
    return stop.stop_requested() ? cancelled() : file.commit();
}

// ---- OpenEXR

constexpr const char* kChannels[] = {"R", "G", "B", "error.R", "error.G", "error.B", "bound.R", "bound.G", "bound.B"};
constexpr std::size_t kChannelCount = std::size(kChannels);

Imf::Header exrHeader(ivec2 size, const Provenance& from) {
    Imf::Header header(size.x, size.y);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : kChannels)
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    Imf::addChromaticities(header, Imf::Chromaticities());  // its default is Rec. 709
    Imf::addComments(
        header,
        "Radiance, linear Rec. 709; error.*: standard error of the mean, 1.96 of which to either side hold "
        "the truth in about 95 % of the tissue; bound.*: what it is at most; both infinite where light is so rare "
        "that they are not known. Not for diagnostic use.");
    header.insert("software", Imf::StringAttribute(from.program));
    header.insert("samplesPerPixel", Imf::DoubleAttribute(double(from.status.samplesPerPixel)));
    header.insert("renderTimeSeconds", Imf::DoubleAttribute(from.seconds));
    insertFacts(header, factsOf(from));
    return header;
}

void encodeExr(const Film& film, const Provenance& provenance, ReplacingFile& file, const std::string& name) {
    const ivec2 size = film.size();
    ExrStream stream(file, name);
    Imf::OutputFile image(stream, exrHeader(size, provenance), 0);

    std::vector<float> row(std::size_t(size.x) * kChannelCount);
    Imf::FrameBuffer frame;
    for (std::size_t channel = 0; channel < kChannelCount; ++channel)  // a row stride of 0: all rows pass through `row`
        frame.insert(kChannels[channel],
                     Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&row[channel]), sizeof(float) * kChannelCount, 0));
    image.setFrameBuffer(frame);
    const denoise::Colours errors = likelyErrors(film, wholeImage(size)), bounds = localErrors(film);
    for (int y = 0; y < size.y; ++y) {
        float* out = row.data();
        for (int x = 0; x < size.x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y);
            for (int channel = 0; channel < 3; ++channel, ++out) {
                out[0] = float(pixel.mean[channel]);
                out[3] = errors[channel].row(y)[x];
                out[6] = bounds[channel].row(y)[x];
            }
            out += 6;
        }
        image.writePixels(1);
    }
}

}  // namespace

Result<void> writePng(const Film& film, const Display& display, const Provenance& provenance,
                      const std::filesystem::path& path, const PaintOver& paintOver, const std::stop_token& stop) {
    DenoisedView view;
    if (display.denoised)
        view.judge(film, film.samplesPerPixel(), stop);
    return writePng(film, display, view, provenance, path, paintOver, stop);
}

Result<void> writePng(const Film& film, const Display& wanted, DenoisedView& view, const Provenance& provenance,
                      const std::filesystem::path& path, const PaintOver& paintOver, const std::stop_token& stop) {
    Result<ReplacingFile> file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();

    const Display display = view.better(wanted);
    std::vector<std::uint8_t> rgba = toneMap(film, display);
    if (paintOver)
        paintOver(film.size(), rgba);
    // Collect the text chunks
    std::vector<Fact> facts = factsOf(provenance);
    if (display.denoised)
        facts.push_back({"pdrender/denoised", denoisedFact(view.error(display), view.lostLines().size())});
    facts.push_back({"Software", provenance.program});
    facts.push_back({"Comment", "Not for diagnostic use."});

    if (!encodePng(film.size(), rgba, facts, *file))
        return Error{phrase("the image could not be encoded as PNG"), path.string(), phrase("Try OpenEXR (.exr).")};
    return commitUnlessStopped(*file, stop);
}

Result<void> writeExr(const Film& film, const Provenance& provenance, const std::filesystem::path& path,
                      const std::stop_token& stop) {
    Result<ReplacingFile> file = ReplacingFile::open(path, FileAccess::owner);
    if (!file)
        return file.error();
    try {
        encodeExr(film, provenance, *file, path.string());
    } catch (const std::exception& failure) {
        if (Result<void> state = file->state(); !state)  // the file has the reason why it could not be written
            return state.error();
        return Error{phrase("the image could not be encoded as OpenEXR (%1)", std::string(failure.what())),
                     path.string(), ""};
    }
    return commitUnlessStopped(*file, stop);
}

Result<RadianceImage> readExr(const std::filesystem::path& path, const Progress& progress) {
    if (auto ok = checkPlainFile(path); !ok)
        return ok.error();
    try {
        Imf::InputFile file(path.c_str());
        const Imath::Box2i window = file.header().dataWindow();
        // Checked before anything of that size is allocated; in 64 bits, since a damaged header may hold any numbers.
        const std::int64_t width = std::int64_t(window.max.x) - window.min.x + 1;
        const std::int64_t height = std::int64_t(window.max.y) - window.min.y + 1;
        if (width < 1 || height < 1 || width > kLongestSide || height > kLongestSide)
            return Error{
                phrase("the image is %1 x %2 pixels, at most %3 x %3 can be read", width, height, kLongestSide),
                path.string(), phrase("Make it smaller.")};
        if (!file.isComplete())
            return Error{phrase("the image is not complete"), path.string(),
                         phrase("Copy the file again from its source.")};
        // Find the channels: R, G and B, or Y
        const Imf::ChannelList& channels = file.header().channels();
        const bool grey = channels.findChannel("Y") != nullptr && channels.findChannel("R") == nullptr;
        RadianceImage image{ivec2(width, height), std::vector<vec3>(std::size_t(width * height))};
        Imf::FrameBuffer frame;
        for (int channel = 0; channel < 3; ++channel) {
            const char* name = grey ? "Y" : kChannels[channel];
            if (channels.findChannel(name) == nullptr)
                return Error{phrase("the image has no channel %1", std::string(name)), path.string(),
                             phrase("It needs R, G and B, or Y.")};
            frame.insert(name, Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][channel], window, sizeof(vec3),
                                                sizeof(vec3) * std::size_t(width)));
            if (grey)
                break;
        }
        file.setFrameBuffer(frame);
        // Read the rows in batches, so that reading can be cancelled
        constexpr int kRows = 256;  // no compression of OpenEXR joins more lines
        for (int y = window.min.y; y <= window.max.y; y += kRows) {
            if (!progress(double(y - window.min.y) / double(height), "reading the image"))
                return cancelled();
            file.readPixels(y, std::min(y + kRows - 1, window.max.y));
        }
        if (grey)
            for (vec3& pixel : image.pixels)
                pixel = vec3(pixel.x);
        return image;
    } catch (const std::exception& failure) {
        return Error{phrase("the image cannot be read as OpenEXR (%1)", std::string(failure.what())), path.string(),
                     phrase("Check the file.")};
    }
}

}  // namespace pdr
