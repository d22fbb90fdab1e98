#include "render/film/file/image_file.h"

#include <ImfChannelList.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStandardAttributes.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <csetjmp>
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

// ---- PNG

void writeChunk(png_structp png, png_bytep bytes, png_size_t count) {
    // The file remembers a failure and reports it at commit, so libpng need not jump.
    static_cast<ReplacingFile*>(png_get_io_ptr(png))->write(bytes, count);
}

void flushNothing(png_structp) {}

struct PngImage {
    ivec2 size;
    std::vector<png_bytep> rows;
    std::vector<png_text> texts;
};

/// Encodes the image. libpng reports errors by longjmp, so nothing in this function may need a destructor.
bool encodePng(png_structp png, png_infop info, PngImage& image) {
    if (setjmp(png_jmpbuf(png)))
        return false;
    png_set_IHDR(png, info, png_uint_32(image.size.x), png_uint_32(image.size.y), 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_text(png, info, image.texts.data(), int(image.texts.size()));
    png_write_info(png, info);
    png_set_filler(png, 0, PNG_FILLER_AFTER);  // drops the alpha, which is 255 everywhere
    png_write_image(png, image.rows.data());
    png_write_end(png, info);
    return true;
}

bool encodePng(PngImage& image, ReplacingFile& file) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (info)
        png_set_write_fn(png, &file, writeChunk, flushNothing);
    const bool ok = info && encodePng(png, info, image);
    png_destroy_write_struct(&png, &info);
    return ok;
}

// ---- OpenEXR

/// An OpenEXR output stream that writes to a ReplacingFile. The library takes exceptions for errors.
class ExrStream : public Imf::OStream {
  public:
    ExrStream(ReplacingFile& file, const std::string& name) : Imf::OStream(name.c_str()), file_(file) {}

    void write(const char bytes[], int count) override {
        if (!file_.write(bytes, std::size_t(count)))
            throw std::ios_base::failure("write");
    }
    std::uint64_t tellp() override { return file_.position(); }
    void seekp(std::uint64_t position) override {
        if (!file_.seek(position))
            throw std::ios_base::failure("seek");
    }

  private:
    ReplacingFile& file_;
};

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
    for (const Fact& fact : factsOf(from))
        if (const auto* words = std::get_if<std::string>(&fact.value))
            header.insert(fact.name, Imf::StringAttribute(*words));
        else
            header.insert(fact.name, Imf::DoubleAttribute(std::get<double>(fact.value)));
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
        facts.push_back({"pdrender/denoised", denoisedFact(view.error(display.exposure), view.lostLines().size())});
    facts.push_back({"Software", provenance.program});
    facts.push_back({"Comment", "Not for diagnostic use."});

    // Point libpng to the rows and the texts
    PngImage image{film.size(), {}, {}};
    for (int y = 0; y < image.size.y; ++y)
        image.rows.push_back(&rgba[std::size_t(y) * std::size_t(image.size.x) * 4]);
    std::vector<std::string> values;
    values.reserve(facts.size());
    for (const Fact& fact : facts)
        values.push_back(textOf(fact));
    for (std::size_t i = 0; i < facts.size(); ++i) {
        png_text entry{};
        entry.compression = PNG_TEXT_COMPRESSION_NONE;
        entry.key = facts[i].name.data();
        entry.text = values[i].data();
        entry.text_length = values[i].size();
        image.texts.push_back(entry);
    }
    if (!encodePng(image, *file))
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
