#include "dicom/file_structure.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctag.h>
#include <dcmtk/dcmdata/dcvr.h>
#include <dcmtk/dcmdata/dcxfer.h>

#include <array>
#include <optional>
#include <vector>

#include "dicom/byte_source.h"

namespace pdr::dicom {

namespace {

constexpr std::uint32_t kUndefined = 0xFFFFFFFF;
constexpr std::uint32_t kItem = 0xFFFEE000, kItemEnd = 0xFFFEE00D, kSequenceEnd = 0xFFFEE0DD;
constexpr std::uint32_t kTransferSyntax = 0x00020010, kPixelData = 0x7FE00010;
constexpr std::uint64_t kPreambleBytes = 128;

struct Encoding {
    bool explicitVr = true;
    bool bigEndian = false;
};

/// The head of one element, as it lies in the file.
struct Element {
    std::uint32_t tag = 0;  ///< group in the upper half
    DcmEVR vr = EVR_UNKNOWN;
    std::uint32_t length = 0;
    std::uint64_t value = 0;  ///< where its value starts
};

std::string hexTag(std::uint32_t tag) {
    char text[16];
    std::snprintf(text, sizeof text, "(%04x,%04x)", unsigned(tag >> 16), unsigned(tag & 0xFFFF));
    return text;
}

std::uint32_t number(const std::uint8_t* bytes, int count, bool bigEndian) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= std::uint32_t(bytes[i]) << 8 * (bigEndian ? count - 1 - i : i);
    return value;
}

DcmEVR dictionaryVr(std::uint32_t tag) {
    return DcmTag(Uint16(tag >> 16), Uint16(tag & 0xFFFF)).getEVR();
}

bool isStandardVr(const std::uint8_t* letters) {
    const char name[3] = {char(letters[0]), char(letters[1]), 0};
    return DcmVR(name).isStandard();
}

/// The head of the element at `at`, or nothing where the file ends inside it.
std::optional<Element> readElement(ByteSource& source, std::uint64_t at, Encoding encoding) {
    std::array<std::uint8_t, 12> head{};
    if (!source.read(at, std::span(head).first(8)))
        return {};
    Element element;
    element.tag = number(&head[0], 2, encoding.bigEndian) << 16 | number(&head[2], 2, encoding.bigEndian);
    element.value = at + 8;
    if (!encoding.explicitVr || element.tag >> 16 == 0xFFFE) {
        element.length = number(&head[4], 4, encoding.bigEndian);
        element.vr = dictionaryVr(element.tag);
        return element;
    }
    const char letters[3] = {char(head[4]), char(head[5]), 0};
    const DcmVR vr(letters);
    element.vr = vr.getEVR();
    element.length = number(&head[6], 2, encoding.bigEndian);
    if (vr.usesExtendedLengthEncoding()) {
        if (!source.read(at + 8, std::span(head).subspan(8, 4)))
            return {};
        element.length = number(&head[8], 4, encoding.bigEndian);
        element.value = at + 12;
    }
    return element;
}

/// Walks one data set with a stack of its own instead of the machine's.
class Walk {
  public:
    Walk(ByteSource& source, std::uint64_t start, Encoding encoding, FileStructure& found)
        : source_(source), at_(start), found_(found) {
        levels_.push_back({source.size(), false, false, encoding});
    }

    void run() {
        while (found_.damage.empty() && next()) {
        }
    }

  private:
    struct Level {
        std::uint64_t end;
        bool openEnded;  ///< ends with a delimiter, not at `end`
        bool isSequence;
        Encoding encoding;
    };

    bool next() {
        while (levels_.size() > 1 && !levels_.back().openEnded && at_ >= levels_.back().end)
            levels_.pop_back();
        if (levels_.size() == 1 && at_ >= source_.size())
            return false;
        const std::optional<Element> element = readElement(source_, at_, levels_.back().encoding);
        if (!element)
            return damaged("it ends in the middle of an element");
        at_ = element->value;
        return levels_.back().isSequence ? inSequence(*element) : inItem(*element);
    }

    bool inSequence(const Element& element) {
        const Level& sequence = levels_.back();
        if (element.tag == kSequenceEnd) {
            levels_.pop_back();
            return true;
        }
        if (element.tag != kItem)
            return damaged("a sequence holds " + hexTag(element.tag) + " where an item should begin");
        return open(element, false, sequence.encoding);
    }

    bool inItem(const Element& element) {
        const Level& level = levels_.back();
        if (element.tag == kItemEnd && level.openEnded) {
            levels_.pop_back();
            return true;
        }
        if (element.tag >> 16 == 0xFFFE)
            return damaged("there is a stray delimiter " + hexTag(element.tag));
        if (element.tag == kPixelData && levels_.size() == 1)
            found_.reachesPixels = true;
        if (element.tag == kPixelData && element.length == kUndefined)
            return skipFragments();
        const bool unknown = element.vr == EVR_UN || element.vr == EVR_UNKNOWN || element.vr == EVR_UNKNOWN2B;
        const bool knownAsSequence = element.vr == EVR_UN && dictionaryVr(element.tag) == EVR_SQ;
        if (element.vr == EVR_SQ || knownAsSequence || (unknown && element.length == kUndefined))
            return open(element, true, unknown ? Encoding{false, false} : level.encoding);
        return skip(element);
    }

    bool skip(const Element& element) {
        if (element.length == kUndefined)
            return damaged("element " + hexTag(element.tag) + " has no length");
        if (!fits(element))
            return false;
        at_ += element.length;
        if (element.tag == kPixelData && levels_.size() == 1)
            found_.pixelBytes = element.length;
        return true;
    }

    bool open(const Element& element, bool isSequence, Encoding encoding) {
        if (levels_.size() > 2 * kMaxNesting)
            return damaged("its sequences are nested more than " + std::to_string(kMaxNesting) + " deep");
        const bool openEnded = element.length == kUndefined;
        if (!openEnded && !fits(element))
            return false;
        levels_.push_back({at_ + element.length, openEnded, isSequence, encoding});
        return true;
    }

    bool skipFragments() {
        const std::uint64_t start = at_;
        for (;;) {
            const std::optional<Element> fragment = readElement(source_, at_, levels_.back().encoding);
            if (!fragment)
                return damaged("it ends inside the compressed picture");
            at_ = fragment->value;
            if (fragment->tag == kSequenceEnd)
                break;
            if (fragment->tag != kItem || fragment->length == kUndefined)
                return damaged("its compressed picture is not made of fragments");
            if (!fits(*fragment))
                return false;
            at_ += fragment->length;
        }
        if (levels_.size() == 1)
            found_.pixelBytes = at_ - start;
        return true;
    }

    bool fits(const Element& element) {
        const std::uint64_t left = source_.size() - element.value;
        if (element.length <= left)
            return true;
        return damaged("element " + hexTag(element.tag) + " should hold " + std::to_string(element.length) +
                       " bytes, but only " + std::to_string(left) + " are left in the file");
    }

    bool damaged(std::string phrase) {
        found_.damage = std::move(phrase);
        return false;
    }

    ByteSource& source_;
    std::uint64_t at_;
    FileStructure& found_;
    std::vector<Level> levels_;
};

/// The coding of a data set that does not say it: by the look of its first element, as the toolkit does.
Encoding detectEncoding(ByteSource& source, std::uint64_t at) {
    std::array<std::uint8_t, 6> head{};
    if (!source.read(at, head))
        return {};
    const bool bigEndian = head[0] == 0 && head[1] != 0;
    return {isStandardVr(&head[4]), bigEndian};
}

std::string uidOf(Encoding encoding) {
    const E_TransferSyntax syntax = !encoding.explicitVr ? EXS_LittleEndianImplicit
                                    : encoding.bigEndian ? EXS_BigEndianExplicit
                                                         : EXS_LittleEndianExplicit;
    return DcmXfer(syntax).getXferID();
}

/// Whether the bytes at `at` can be the first element of a DICOM file: group 0002 or 0008, known, of sensible length.
bool looksLikeElement(ByteSource& source, std::uint64_t at) {
    const Encoding encoding = detectEncoding(source, at);
    const std::optional<Element> element = readElement(source, at, encoding);
    if (!element)
        return false;
    const std::uint32_t group = element->tag >> 16;
    return (group == 0x0002 || group == 0x0008) && dictionaryVr(element->tag) != EVR_UN && element->length <= 1024;
}

/// Reads group 0002 from `at` on; returns where the data set starts.
std::uint64_t readMeta(ByteSource& source, std::uint64_t at, FileStructure& found) {
    const Encoding encoding{detectEncoding(source, at).explicitVr, false};
    for (;;) {
        const std::optional<Element> element = readElement(source, at, encoding);
        if (!element || element->tag >> 16 != 0x0002)
            return at;
        found.hasMetaHeader = true;
        if (element->length > source.size() - element->value) {
            found.damage = "element " + hexTag(element->tag) + " is longer than the file";
            return at;
        }
        if (element->tag == kTransferSyntax && element->length <= 64) {
            std::array<std::uint8_t, 64> uid{};
            source.read(element->value, std::span(uid).first(element->length));
            found.transferSyntaxUid = reinterpret_cast<const char*>(std::string(uid.begin(), uid.end()).c_str());
            while (!found.transferSyntaxUid.empty() && found.transferSyntaxUid.back() == ' ')
                found.transferSyntaxUid.pop_back();
        }
        at = element->value + element->length;
    }
}

void walkDataSet(ByteSource& source, std::uint64_t start, FileStructure& found) {
    const DcmXfer stated(found.transferSyntaxUid.c_str());
    if (found.transferSyntaxUid.empty() || stated.getXfer() == EXS_Unknown) {
        const Encoding encoding = detectEncoding(source, start);
        found.transferSyntaxUid = found.transferSyntaxUid.empty() ? uidOf(encoding) : found.transferSyntaxUid;
        Walk(source, start, encoding, found).run();
        return;
    }
    const Encoding encoding{bool(stated.isExplicitVR()), bool(stated.isBigEndian())};
    if (stated.getStreamCompression() != ESC_zlib) {
        Walk(source, start, encoding, found).run();
        return;
    }
    ByteSource inflated(inflateFrom(source, start, kMaxInflatedBytes));
    if (inflated.size() == 0)
        found.damage = "its deflated content is damaged, or larger than 256 MB";
    else
        Walk(inflated, 0, encoding, found).run();
}

}  // namespace

FileStructure checkStructure(const std::filesystem::path& file) {
    FileStructure found;
    ByteSource source(file);
    if (!source.isOpen()) {
        found.isDicom = true;
        found.damage = "it cannot be opened";
        return found;
    }
    std::array<std::uint8_t, 4> magic{};
    const bool hasPreamble = source.read(kPreambleBytes, magic) && std::string(magic.begin(), magic.end()) == "DICM";
    const std::uint64_t start = hasPreamble ? kPreambleBytes + 4 : 0;
    found.isDicom = hasPreamble || looksLikeElement(source, start);
    if (!found.isDicom)
        return found;
    const std::uint64_t dataSet = readMeta(source, start, found);
    if (!found.damage.empty())
        return found;
    if (dataSet >= source.size())
        found.damage = "it ends after its header";
    else
        walkDataSet(source, dataSet, found);
    return found;
}

}  // namespace pdr::dicom
