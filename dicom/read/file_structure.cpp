#include "dicom/read/file_structure.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcxfer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <vector>

#include "dicom/read/element.h"

namespace pdr::dicom {

namespace {

constexpr std::uint64_t kPreambleBytes = 128;
/// Largest value that the toolkit reads into memory with the header [bytes]; it reads longer ones only when they are
/// requested.
constexpr std::uint32_t kReadAtOnce = 4096;

/// Counts what the toolkit would have to hold of a file, and asks whether the result is still needed.
class Allowance {
  public:
    Allowance(const GoOn& goOn, FileStructure& found) : goOn_(goOn), found_(found) {}

    /// Counts one element, item or fragment; if there are too many, sets the damage and returns false.
    bool take(const Element& element) {
        // Most elements are small: a thousand of them take less than a millisecond.
        if (++elements_ % 1000 == 0 && !goOn_())
            found_.damage = phrase("cancelled");
        const bool isRead = element.length <= kReadAtOnce || element.text != Element::Text::none;
        bytes_ += isRead && element.length != kUndefined ? element.length : 0;
        if (elements_ > maxElements_)
            found_.damage = tooManyElements();
        else if (bytes_ > maxBytes_)
            found_.damage = phrase("its header takes more than %1 MB", maxBytes_ >> 20);
        return found_.damage.empty();
    }

    /// Allows for what describes `frames` frames.
    void raiseFor(int frames) {
        frames = std::clamp(frames, 0, kMaxFrames);
        maxElements_ = std::min(kMaxElements + frames * kMaxFrameElements, kMaxElementsOfAll);
        maxBytes_ = std::min(kMaxHeaderBytes + std::size_t(frames) * kMaxFrameBytes, kMaxHeaderBytesOfAll);
    }

    /// Counts the values of `element`, which lies within `source`; if there are too many, sets the damage and returns
    /// false.
    bool takeText(ByteSource& source, const Element& element) {
        if (element.text != Element::Text::list || element.length < kShortText)
            return true;
        if (element.length > kMaxListBytes) {
            found_.damage = phrase("the text %1 is longer than %2 kB", hexTag(element.tag), kMaxListBytes >> 10);
            return false;
        }
        text_.resize(element.length);
        source.read(element.value, text_);
        const auto values = int(std::ranges::count(text_, '\\')) + 1;
        elements_ += values;
        if (values > kMaxListValues)
            found_.damage = phrase("the text %1 has more than %2 values", hexTag(element.tag), kMaxListValues);
        else if (elements_ > maxElements_)
            found_.damage = tooManyElements();
        return found_.damage.empty();
    }

  private:
    /// Length below which a text has too few values to count.
    static constexpr std::uint32_t kShortText = 64;

    Text tooManyElements() const {
        return phrase("it holds more than %1 elements, items, fragments and values", maxElements_);
    }

    const GoOn& goOn_;
    FileStructure& found_;
    std::vector<std::uint8_t> text_;
    int elements_ = 0, maxElements_ = kMaxElements;
    std::size_t bytes_ = 0, maxBytes_ = kMaxHeaderBytes;
};

/// Walks one data set with a stack of its own instead of recursion.
class Walk {
  public:
    Walk(ByteSource& source, std::uint64_t start, Encoding encoding, Allowance& allowance, FileStructure& found)
        : source_(source), at_(start), allowance_(allowance), found_(found) {
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
            return damaged(phrase("it ends in the middle of an element"));
        if (!allowance_.take(*element))
            return false;
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
            return damaged(phrase("a sequence holds %1 where an item should begin", hexTag(element.tag)));
        return open(element, false, sequence.encoding);
    }

    /// Returns whether `element` holds the pixels of the object, not those of an icon in a sequence.
    bool isImage(const Element& element) const {
        return levels_.size() == 1 &&
               (element.tag == kPixelData || element.tag == kFloatPixelData || element.tag == kDoubleFloatPixelData);
    }

    bool inItem(const Element& element) {
        const Level& level = levels_.back();
        if (element.tag == kItemEnd && level.openEnded) {
            levels_.pop_back();
            return true;
        }
        if (element.tag >> 16 == 0xFFFE)
            return damaged(phrase("there is a stray delimiter %1", hexTag(element.tag)));
        if (isImage(element)) {
            found_.hasPixelsTwice = found_.reachesPixels;
            found_.reachesPixels = true;
            found_.pixelsAt = element.value;
        }
        if (element.tag == kPixelData && element.length == kUndefined)
            return skipFragments();
        using Kind = Element::Kind;
        const bool written = element.kind == Kind::sequence;
        if (written || element.kind == Kind::unknownSequence ||
            (element.kind == Kind::unknown && element.length == kUndefined))
            return open(element, true, written ? level.encoding : Encoding{false, false});
        return skip(element);
    }

    bool skip(const Element& element) {
        if (element.length == kUndefined)
            return damaged(phrase("element %1 has no length", hexTag(element.tag)));
        if (!fits(element))
            return false;
        if (!allowance_.takeText(source_, element))
            return false;
        if (element.tag == kNumberOfFrames && levels_.size() == 1)
            allowance_.raiseFor(frameCount(element));
        at_ += element.length;
        if (isImage(element))
            found_.pixelBytes = element.length;
        return true;
    }

    /// Returns the number that an element states as text; 0 if that is no number.
    int frameCount(const Element& element) {
        std::array<std::uint8_t, 12> digits{};
        if (element.length > digits.size() || !source_.read(element.value, std::span(digits).first(element.length)))
            return 0;
        int count = 0;
        const auto* first = reinterpret_cast<const char*>(digits.data());
        std::from_chars(first, first + element.length, count);
        return count;
    }

    bool open(const Element& element, bool isSequence, Encoding encoding) {
        if (levels_.size() > 2 * kMaxNesting)
            return damaged(phrase("its sequences are nested more than %1 deep", kMaxNesting));
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
                return damaged(phrase("it ends inside the compressed image"));
            at_ = fragment->value;
            if (fragment->tag == kSequenceEnd)
                break;
            if (fragment->tag != kItem || fragment->length == kUndefined)
                return damaged(phrase("its compressed image is not made of fragments"));
            if (!fits(*fragment) || !allowance_.take({.tag = fragment->tag, .length = kUndefined}))
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
        return damaged(phrase("element %1 should hold %2 bytes, but only %3 are left in the file", hexTag(element.tag),
                              element.length, left));
    }

    bool damaged(Text damage) {
        found_.damage = std::move(damage);
        return false;
    }

    ByteSource& source_;
    std::uint64_t at_;
    Allowance& allowance_;
    FileStructure& found_;
    std::vector<Level> levels_;
};

std::string uidOf(Encoding encoding) {
    const E_TransferSyntax syntax = !encoding.explicitVr ? EXS_LittleEndianImplicit
                                    : encoding.bigEndian ? EXS_BigEndianExplicit
                                                         : EXS_LittleEndianExplicit;
    return DcmXfer(syntax).getXferID();
}

/// Reads group 0002 from `at` on; returns where the data set starts.
std::uint64_t readMeta(ByteSource& source, std::uint64_t at, Allowance& allowance, FileStructure& found) {
    const Encoding encoding{detectEncoding(source, at).explicitVr, false};
    for (;;) {
        const std::optional<Element> element = readElement(source, at, encoding);
        if (!element || element->tag >> 16 != 0x0002)
            return at;
        found.hasMetaHeader = true;
        if (!allowance.take(*element))
            return at;
        if (element->length > source.size() - element->value) {
            found.damage = phrase("element %1 is longer than the file", hexTag(element->tag));
            return at;
        }
        if (!allowance.takeText(source, *element))
            return at;
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

void walkDataSet(ByteSource& source, std::uint64_t start, const GoOn& goOn, Allowance& allowance,
                 FileStructure& found) {
    const DcmXfer stated(found.transferSyntaxUid.c_str());
    if (found.transferSyntaxUid.empty() || stated.getXfer() == EXS_Unknown) {
        const Encoding encoding = detectEncoding(source, start);
        found.transferSyntaxUid = found.transferSyntaxUid.empty() ? uidOf(encoding) : found.transferSyntaxUid;
        Walk(source, start, encoding, allowance, found).run();
        return;
    }
    const Encoding encoding{bool(stated.isExplicitVR()), bool(stated.isBigEndian())};
    if (stated.getStreamCompression() != ESC_zlib) {
        Walk(source, start, encoding, allowance, found).run();
        return;
    }
    ByteSource inflated(inflateFrom(source, start, kMaxInflatedBytes, goOn));
    if (inflated.size() == 0)
        found.damage = phrase("its deflated content is damaged, or larger than %1 MB", kMaxInflatedBytes >> 20);
    else
        Walk(inflated, 0, encoding, allowance, found).run();
}

}  // namespace

FileStructure checkStructure(const NamedBytes& object, const GoOn& goOn) {
    FileStructure found;
    Allowance allowance(goOn, found);
    ByteSource source(object);
    if (!source.opened()) {
        found.isDicom = true;
        found.damage = source.opened().error().what;
        return found;
    }
    std::array<std::uint8_t, 4> magic{};
    const bool hasPreamble = source.read(kPreambleBytes, magic) && std::string(magic.begin(), magic.end()) == "DICM";
    const std::uint64_t start = hasPreamble ? kPreambleBytes + 4 : 0;
    found.isDicom = hasPreamble || looksLikeElement(source, start);
    if (!found.isDicom)
        return found;
    const std::uint64_t dataSet = readMeta(source, start, allowance, found);
    if (!found.damage.empty())
        return found;
    if (dataSet >= source.size())
        found.damage = phrase("it ends after its header");
    else
        walkDataSet(source, dataSet, goOn, allowance, found);
    return found;
}

}  // namespace pdr::dicom
