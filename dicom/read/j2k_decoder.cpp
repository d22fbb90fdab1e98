#include "dicom/read/j2k_decoder.h"

#include <openjpeg-2.5/openjpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <span>
#include <string>

namespace pdr::dicom {

namespace {

/// A codestream in memory, as OpenJPEG reads it.
class Reader {
  public:
    explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)> stream() {
        constexpr std::size_t kBuffer = 1 << 16;
        std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)> stream(opj_stream_create(kBuffer, OPJ_TRUE),
                                                                            opj_stream_destroy);
        if (!stream)
            return stream;
        opj_stream_set_user_data(stream.get(), this, nullptr);
        opj_stream_set_user_data_length(stream.get(), bytes_.size());
        opj_stream_set_read_function(stream.get(), read);
        opj_stream_set_skip_function(stream.get(), skip);
        opj_stream_set_seek_function(stream.get(), seek);
        return stream;
    }

  private:
    static OPJ_SIZE_T read(void* out, OPJ_SIZE_T count, void* self) {
        auto& reader = *static_cast<Reader*>(self);
        const std::size_t taken = std::min<std::size_t>(count, reader.bytes_.size() - reader.at_);
        if (taken == 0)
            return OPJ_SIZE_T(-1);
        std::memcpy(out, reader.bytes_.data() + reader.at_, taken);
        reader.at_ += taken;
        return taken;
    }
    static OPJ_OFF_T skip(OPJ_OFF_T count, void* self) {
        auto& reader = *static_cast<Reader*>(self);
        if (count < 0)
            return -1;
        const std::size_t taken = std::min(std::size_t(count), reader.bytes_.size() - reader.at_);
        reader.at_ += taken;
        return OPJ_OFF_T(taken);
    }
    static OPJ_BOOL seek(OPJ_OFF_T place, void* self) {
        auto& reader = *static_cast<Reader*>(self);
        if (place < 0 || std::size_t(place) > reader.bytes_.size())
            return OPJ_FALSE;
        reader.at_ = std::size_t(place);
        return OPJ_TRUE;
    }

    std::span<const std::uint8_t> bytes_;
    std::size_t at_ = 0;
};

/// The first thing that a decoder complained about, without the end of its line.
struct Complaint {
    std::string text;

    static void take(const char* text, void* self) {
        auto& complaint = *static_cast<Complaint*>(self);
        if (complaint.text.empty())
            complaint.text = std::string(text, std::strcspn(text, "\r\n"));
    }
};

using Codec = std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)>;
using Image = std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)>;

/// Sets up `codec` so that it refuses incomplete streams and reports to `complaint`.
bool setUp(const Codec& codec, Complaint& complaint) {
    if (!codec)
        return false;
    opj_set_warning_handler(codec.get(), Complaint::take, &complaint);
    opj_set_error_handler(codec.get(), Complaint::take, &complaint);
    opj_dparameters_t parameters;
    opj_set_default_decoder_parameters(&parameters);
    return opj_setup_decoder(codec.get(), &parameters) && opj_decoder_set_strict_mode(codec.get(), OPJ_TRUE);
}

/// Decodes `bytes`, or returns null and says why.
Image decoded(std::span<const std::uint8_t> bytes, Complaint& complaint) {
    Image image(nullptr, opj_image_destroy);
    const Codec codec(opj_create_decompress(OPJ_CODEC_J2K), opj_destroy_codec);
    Reader reader(bytes);
    const auto stream = reader.stream();
    if (!stream || !setUp(codec, complaint))
        return image;
    opj_image_t* raw = nullptr;
    const bool hasHeader = opj_read_header(stream.get(), codec.get(), &raw);
    image.reset(raw);
    const bool isComplete = hasHeader && opj_decode(codec.get(), stream.get(), raw) &&
                            opj_end_decompress(codec.get(), stream.get()) && complaint.text.empty();
    if (!isComplete)
        image.reset();
    return image;
}

}  // namespace

J2kImage decodeJ2k(std::vector<std::uint8_t> stream, ivec2 size) {
    trimToCodestream(stream);
    J2kImage image{readJ2k(stream)};
    Text& damage = image.stream.damage;
    if (!damage.empty())
        return image;
    if (image.stream.size != size) {
        damage = phrase("it is not of the size that the file's header says");
        return image;
    }
    if (image.stream.components != 1 || image.stream.precision > 16) {
        damage = phrase("it is no grey image of at most 16 bits");
        return image;
    }
    image.isMended = mendLastLength(stream);
    Complaint complaint;
    const Image pixels = decoded(stream, complaint);
    if (!pixels) {
        damage = phrase("its decoder says \"%1\"", complaint.text);
        return image;
    }
    const opj_image_comp_t& grey = pixels->comps[0];
    if (ivec2(int(grey.w), int(grey.h)) != size || grey.data == nullptr)
        damage = phrase("it is not of the size that the file's header says");
    else
        image.words.assign(grey.data, grey.data + std::size_t(size.x) * std::size_t(size.y));
    return image;
}

}  // namespace pdr::dicom
