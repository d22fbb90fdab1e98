#include "render/film/file/png_encoder.h"

#include <png.h>

#include <csetjmp>
#include <string>

namespace pdr {
namespace {

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
bool encode(png_structp png, png_infop info, PngImage& image) {
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

bool encode(PngImage& image, ReplacingFile& file) {
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png ? png_create_info_struct(png) : nullptr;
    if (info)
        png_set_write_fn(png, &file, writeChunk, flushNothing);
    const bool ok = info && encode(png, info, image);
    png_destroy_write_struct(&png, &info);
    return ok;
}

}  // namespace

bool encodePng(ivec2 size, std::vector<std::uint8_t>& rgba, std::vector<Fact> facts, ReplacingFile& file) {
    // Point libpng to the rows and the texts
    PngImage image{size, {}, {}};
    for (int y = 0; y < size.y; ++y)
        image.rows.push_back(&rgba[std::size_t(y) * std::size_t(size.x) * 4]);
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
    return encode(image, file);
}

}  // namespace pdr
