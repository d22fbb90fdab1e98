#include "dicom/read/frame_object.h"

#include <string>
#include <string_view>
#include <utility>

#include "dicom/read/element.h"

namespace pdr::dicom {

namespace {

/// Writes elements in explicit little endian (PS3.5, 7.1.2), in ascending order of their tags.
class ElementWriter {
  public:
    void number(std::uint32_t tag, int value) {
        header(tag, "US", 2);
        little(std::uint32_t(value), 2);
    }

    void text(std::uint32_t tag, std::string value) {
        value.resize((value.size() + 1) / 2 * 2, ' ');
        header(tag, "CS", int(value.size()));
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }

    void pixels(std::span<const std::uint8_t> stream) {
        header(kPixelData, "OB", 0);
        little(kUndefined, 4);
        item(kItem, 0);  // the offset table
        item(kItem, std::uint32_t(stream.size() + stream.size() % 2));
        bytes_.insert(bytes_.end(), stream.begin(), stream.end());
        bytes_.resize(bytes_.size() + stream.size() % 2);
        item(kSequenceEnd, 0);
    }

    std::vector<std::uint8_t> take() { return std::move(bytes_); }

  private:
    void little(std::uint32_t value, int count) {
        for (int i = 0; i < count; ++i)
            bytes_.push_back(std::uint8_t(value >> 8 * i));
    }
    void tag(std::uint32_t tag) {
        little(tag >> 16, 2);
        little(tag, 2);
    }
    void header(std::uint32_t tag, std::string_view representation, int length) {
        this->tag(tag);
        bytes_.insert(bytes_.end(), representation.begin(), representation.end());
        little(std::uint32_t(length), 2);
    }
    void item(std::uint32_t tag, std::uint32_t length) {
        this->tag(tag);
        little(length, 4);
    }

    std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::vector<std::uint8_t> frameObject(const SliceHeader& header, std::span<const std::uint8_t> stream) {
    const PixelFormat& format = header.format;
    ElementWriter writer;
    writer.number(0x00280002, format.samplesPerPixel);
    writer.text(0x00280004, format.photometric);
    writer.number(0x00280010, header.rows);
    writer.number(0x00280011, header.columns);
    writer.number(0x00280100, format.bitsAllocated);
    writer.number(0x00280101, format.bitsStored);
    writer.number(0x00280102, format.highBit);
    writer.number(0x00280103, format.isSigned ? 1 : 0);
    writer.pixels(stream);
    return writer.take();
}

}  // namespace pdr::dicom
