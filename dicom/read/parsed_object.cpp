#include "dicom/read/parsed_object.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcistrma.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cstring>
#include <span>

namespace pdr::dicom {

namespace {

/// Hands bytes in memory to the toolkit. Its own class for that takes no odd number of bytes, which damaged files have.
class MemoryProducer : public DcmProducer {
  public:
    explicit MemoryProducer(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

    OFBool good() const override { return status_.good(); }
    OFCondition status() const override { return status_; }
    OFBool eos() override { return avail() == 0; }
    offile_off_t avail() override { return offile_off_t(bytes_.size()) - at_; }

    offile_off_t read(void* out, offile_off_t count) override {
        const offile_off_t from = at_;
        const offile_off_t taken = skip(count);
        std::memcpy(out, bytes_.data() + from, std::size_t(taken));
        return taken;
    }
    offile_off_t skip(offile_off_t count) override {
        const offile_off_t taken = std::min(count, avail());
        at_ += taken;
        return taken;
    }
    void putback(offile_off_t count) override {
        if (count > at_)
            status_ = EC_PutbackFailed;
        else
            at_ -= count;
    }

  private:
    std::span<const std::uint8_t> bytes_;
    offile_off_t at_ = 0;
    OFCondition status_ = EC_Normal;
};

class MemoryStream : public DcmInputStream {
  public:
    explicit MemoryStream(std::span<const std::uint8_t> bytes) : DcmInputStream(&producer_), producer_(bytes) {}

    /// Returns null: all values are read at once.
    DcmInputStreamFactory* newFactory() const override { return nullptr; }

  private:
    MemoryProducer producer_;
};

/// Parses a meta header and a data set, or a data set alone.
template <class Object>
OFCondition parse(Object& object, DcmInputStream& stream, E_TransferSyntax coding, const DcmTagKey& stop) {
    object.transferInit();
    const OFCondition outcome = object.readUntilTag(stream, coding, EGL_noChange, DCM_MaxReadLength, stop);
    object.transferEnd();
    return outcome;
}

}  // namespace

bool parseObject(const NamedBytes& object, const SliceHeader& header, Extent extent, DcmFileFormat& content) {
    const DcmTagKey stop = extent == Extent::header ? DCM_PixelData : DCM_UndefinedTagKey;
    const E_TransferSyntax coding =
        header.hasMetaHeader ? EXS_Unknown : DcmXfer(header.transferSyntaxUid.c_str()).getXfer();
    if (!object.memory) {
        const E_FileReadMode mode = header.hasMetaHeader ? ERM_autoDetect : ERM_dataset;
        return content.loadFileUntilTag(object.name.c_str(), coding, EGL_noChange, DCM_MaxReadLength, mode, stop)
            .good();
    }
    MemoryStream stream(*object.memory);
    return header.hasMetaHeader ? parse(content, stream, coding, stop).good()
                                : parse(*content.getDataset(), stream, coding, stop).good();
}

}  // namespace pdr::dicom
