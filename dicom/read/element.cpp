#include "dicom/read/element.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctag.h>
#include <dcmtk/dcmdata/dcvr.h>

#include <array>
#include <cstdio>
#include <span>

namespace pdr::dicom {

namespace {

std::uint32_t number(const std::uint8_t* bytes, int count, bool bigEndian) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i)
        value |= std::uint32_t(bytes[i]) << 8 * (bigEndian ? count - 1 - i : i);
    return value;
}

bool isStandardVr(const std::uint8_t* letters) {
    const char name[3] = {char(letters[0]), char(letters[1]), 0};
    return DcmVR(name).isStandard();
}

DcmEVR dictionaryVr(std::uint32_t tag) {
    return DcmTag(Uint16(tag >> 16), Uint16(tag & 0xFFFF)).getEVR();
}

Element::Kind kindOf(DcmEVR vr, std::uint32_t tag) {
    if (vr == EVR_SQ)
        return Element::Kind::sequence;
    if (vr == EVR_UN && dictionaryVr(tag) == EVR_SQ)
        return Element::Kind::unknownSequence;
    const bool unknown = vr == EVR_UN || vr == EVR_UNKNOWN || vr == EVR_UNKNOWN2B;
    return unknown ? Element::Kind::unknown : Element::Kind::plain;
}

/// Returns how the values of a representation are text. Decimal numbers do not count: contours may have thousands of
/// them, which are never read.
Element::Text textOf(DcmEVR vr) {
    switch (vr) {
        case EVR_AE:
        case EVR_AS:
        case EVR_CS:
        case EVR_DA:
        case EVR_DT:
        case EVR_LO:
        case EVR_PN:
        case EVR_SH:
        case EVR_TM:
        case EVR_UC:
        case EVR_UI:
            return Element::Text::list;
        case EVR_LT:
        case EVR_ST:
        case EVR_UT:
            return Element::Text::plain;
        default:
            return Element::Text::none;
    }
}

}  // namespace

std::string hexTag(std::uint32_t tag) {
    char text[16];
    std::snprintf(text, sizeof text, "(%04x,%04x)", unsigned(tag >> 16), unsigned(tag & 0xFFFF));
    return text;
}

std::optional<Element> readElement(ByteSource& source, std::uint64_t at, Encoding encoding) {
    std::array<std::uint8_t, 12> head{};
    if (!source.read(at, std::span(head).first(8)))
        return {};
    Element element;
    element.tag = number(&head[0], 2, encoding.bigEndian) << 16 | number(&head[2], 2, encoding.bigEndian);
    element.value = at + 8;
    // The dictionary knows the representation of implicit elements and of items
    if (!encoding.explicitVr || element.tag >> 16 == 0xFFFE) {
        element.length = number(&head[4], 4, encoding.bigEndian);
        element.kind = kindOf(dictionaryVr(element.tag), element.tag);
        element.text = textOf(dictionaryVr(element.tag));
        return element;
    }
    // An explicit element states its representation
    const char letters[3] = {char(head[4]), char(head[5]), 0};
    const DcmVR vr(letters);
    element.kind = kindOf(vr.getEVR(), element.tag);
    element.text = textOf(vr.getEVR());
    element.length = number(&head[6], 2, encoding.bigEndian);
    if (vr.usesExtendedLengthEncoding()) {
        if (!source.read(at + 8, std::span(head).subspan(8, 4)))
            return {};
        element.length = number(&head[8], 4, encoding.bigEndian);
        element.value = at + 12;
    }
    return element;
}

Encoding detectEncoding(ByteSource& source, std::uint64_t at) {
    std::array<std::uint8_t, 6> head{};
    if (!source.read(at, head))
        return {};
    const bool bigEndian = head[0] == 0 && head[1] != 0;
    return {isStandardVr(&head[4]), bigEndian};
}

bool looksLikeElement(ByteSource& source, std::uint64_t at) {
    const Encoding encoding = detectEncoding(source, at);
    const std::optional<Element> element = readElement(source, at, encoding);
    if (!element)
        return false;
    const std::uint32_t group = element->tag >> 16;
    return (group == 0x0002 || group == 0x0008) && dictionaryVr(element->tag) != EVR_UN && element->length <= 1024;
}

}  // namespace pdr::dicom
