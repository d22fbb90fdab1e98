#include "dicom/read/parsed_object.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcistrma.h>
#include <dcmtk/dcmdata/dcistrmf.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
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

/// Hands bytes to the toolkit until nobody waits for the result any more: it then stops, as at the end of a file that
/// was cut off. Parsing the groups of a thousand frames takes a third of a second otherwise.
class StoppableProducer : public DcmProducer {
  public:
    StoppableProducer(DcmProducer& bytes, const GoOn& goOn) : bytes_(bytes), goOn_(goOn) {}

    OFBool good() const override { return !isStopped_ && bytes_.good(); }
    OFCondition status() const override { return isStopped_ ? EC_InvalidStream : bytes_.status(); }
    OFBool eos() override { return isStopped_ || bytes_.eos(); }
    offile_off_t avail() override { return isStopped_ ? 0 : bytes_.avail(); }
    offile_off_t read(void* out, offile_off_t count) override { return goesOn() ? bytes_.read(out, count) : 0; }
    offile_off_t skip(offile_off_t count) override { return goesOn() ? bytes_.skip(count) : 0; }
    void putback(offile_off_t count) override {
        if (!isStopped_)
            bytes_.putback(count);
    }

  private:
    bool goesOn() {
        isStopped_ = isStopped_ || !goOn_();
        return !isStopped_;
    }

    DcmProducer& bytes_;
    const GoOn& goOn_;
    bool isStopped_ = false;
};

class StoppableStream : public DcmInputStream {
  public:
    /// `file`: where the bytes come from; empty: memory.
    StoppableStream(DcmProducer& bytes, const GoOn& goOn, const std::filesystem::path& file)
        : DcmInputStream(&producer_), producer_(bytes, goOn), file_(file.c_str()) {}

    /// Returns what reads long values when they are asked for. Null, so that they are read at once: bytes in memory,
    /// and deflated ones, which have no place in the file.
    DcmInputStreamFactory* newFactory() const override {
        return file_.isEmpty() || currentProducer() != &producer_ ? nullptr
                                                                  : new DcmInputFileStreamFactory(file_, tell());
    }

  private:
    StoppableProducer producer_;
    OFFilename file_;
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

bool parseObject(const NamedBytes& object, const SliceHeader& header, Extent extent, DcmFileFormat& content,
                 const GoOn& goOn) {
    const DcmTagKey stop = extent == Extent::header ? DCM_PixelData : DCM_UndefinedTagKey;
    const E_TransferSyntax coding =
        header.hasMetaHeader ? EXS_Unknown : DcmXfer(header.transferSyntaxUid.c_str()).getXfer();
    const auto parseFrom = [&](DcmProducer& bytes, const std::filesystem::path& file) {
        StoppableStream stream(bytes, goOn, file);
        return header.hasMetaHeader ? parse(content, stream, coding, stop).good()
                                    : parse(*content.getDataset(), stream, coding, stop).good();
    };
    if (object.memory) {
        MemoryProducer bytes(*object.memory);
        return parseFrom(bytes, {});
    }
    DcmFileProducer bytes(object.name.c_str());
    return parseFrom(bytes, object.name);
}

}  // namespace pdr::dicom
