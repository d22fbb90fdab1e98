#pragma once
/// CT slices in JPEG 2000 and High-Throughput JPEG 2000.

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <openjpeg-2.5/openjpeg.h>

#include <cstring>
#include <memory>
#include <vector>

#include "tests/support/dicom/damaged_streams.h"

namespace pdr::test {

struct J2kCoding {
    int precision = 16;  ///< bits per sample
    bool isSigned = true;
    double ratio = 0;  ///< how much smaller it is to become; 0: nothing is lost
};

/// Returns the codestream of a grey image.
inline std::vector<std::uint8_t> j2kStream(ivec2 size, const std::vector<int>& values, const J2kCoding& coding) {
    opj_image_cmptparm_t component{};
    component.dx = component.dy = 1;
    component.w = OPJ_UINT32(size.x);
    component.h = OPJ_UINT32(size.y);
    component.prec = OPJ_UINT32(coding.precision);
    component.sgnd = coding.isSigned;
    const std::unique_ptr<opj_image_t, decltype(&opj_image_destroy)> image(
        opj_image_create(1, &component, OPJ_CLRSPC_GRAY), opj_image_destroy);
    image->x1 = OPJ_UINT32(size.x);
    image->y1 = OPJ_UINT32(size.y);
    std::copy(values.begin(), values.end(), image->comps[0].data);
    opj_cparameters_t parameters;
    opj_set_default_encoder_parameters(&parameters);
    parameters.irreversible = coding.ratio > 0;
    parameters.tcp_numlayers = 1;
    parameters.tcp_rates[0] = float(coding.ratio);
    parameters.cp_disto_alloc = 1;
    parameters.numresolution = 4;
    const std::unique_ptr<opj_codec_t, decltype(&opj_destroy_codec)> codec(opj_create_compress(OPJ_CODEC_J2K),
                                                                           opj_destroy_codec);
    struct Bytes {
        std::vector<std::uint8_t> all;
        std::size_t at = 0;
    } bytes;
    const std::unique_ptr<opj_stream_t, decltype(&opj_stream_destroy)> stream(opj_stream_default_create(OPJ_FALSE),
                                                                              opj_stream_destroy);
    opj_stream_set_user_data(stream.get(), &bytes, nullptr);
    opj_stream_set_write_function(stream.get(), [](void* from, OPJ_SIZE_T count, void* self) {
        auto& to = *static_cast<Bytes*>(self);
        to.all.resize(std::max(to.all.size(), to.at + count));
        std::memcpy(to.all.data() + to.at, from, count);
        to.at += count;
        return count;
    });
    opj_stream_set_seek_function(stream.get(), [](OPJ_OFF_T place, void* self) {
        static_cast<Bytes*>(self)->at = std::size_t(place);
        return OPJ_BOOL(OPJ_TRUE);
    });
    const bool isDone = opj_setup_encoder(codec.get(), &parameters, image.get()) &&
                        opj_start_compress(codec.get(), image.get(), stream.get()) &&
                        opj_encode(codec.get(), stream.get()) && opj_end_compress(codec.get(), stream.get());
    if (!isDone)
        qFatal("the test cannot encode its image");
    return bytes.all;
}

/// Writes `slice` with that codestream as its pixels. `uid`: the transfer syntax.
inline void writeJ2kSlice(const std::filesystem::path& file, const SliceFile& slice, std::vector<std::uint8_t> stream,
                          const char* uid) {
    dicom::prepareToolkit();
    writeSliceFile(file, slice);
    DcmFileFormat content;
    if (content.loadFile(file.c_str()).bad())
        qFatal("the test cannot read its file");
    auto* fragments = new DcmPixelSequence(DCM_PixelSequenceTag);
    fragments->insert(new DcmPixelItem(DCM_PixelItemTag));
    DcmOffsetList offsets;
    fragments->storeCompressedFrame(offsets, stream.data(), Uint32(stream.size()), 0);
    auto* pixels = new DcmPixelData(DCM_PixelData);
    pixels->putOriginalRepresentation(EXS_JPEG2000LosslessOnly, nullptr, fragments);
    content.getDataset()->insert(pixels, true);
    if (content.saveFile(file.c_str(), EXS_JPEG2000LosslessOnly).bad())
        qFatal("the test cannot write its file");
    // The toolkit cannot write the newer syntaxes.
    std::string bytes = bytesOf(file), named(uid);
    const std::string written(
        "UI\x16\0"
        "1.2.840.10008.1.2.4.90",
        26);
    named.resize((named.size() + 1) / 2 * 2, '\0');
    bytes.replace(bytes.find(written), written.size(), "UI" + std::string(1, char(named.size())) + '\0' + named);
    writeBytes(file, bytes);
}

}  // namespace pdr::test
