#include "dicom/read/item_values.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace pdr::dicom {

namespace {

constexpr std::size_t kLongestText = 512;

std::optional<double> number(std::string_view written) {
    while (!written.empty() && (written.back() == ' ' || written.back() == '\0'))
        written.remove_suffix(1);
    while (!written.empty() && (written.front() == ' ' || written.front() == '+'))
        written.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(written.data(), written.data() + written.size(), value);
    if (failure != std::errc() || end != written.data() + written.size() || !std::isfinite(value))
        return {};
    return value;
}

}  // namespace

std::optional<double> numberAt(DcmItem& item, const DcmTagKey& tag, int index) {
    OFString written;
    if (item.findAndGetOFString(tag, written, static_cast<unsigned long>(index)).bad())
        return {};
    return number({written.c_str(), written.size()});
}

int shortValue(DcmItem& item, const DcmTagKey& tag, int absent) {
    Uint16 value = 0;
    return item.findAndGetUint16(tag, value).good() ? int(value) : absent;
}

int integerValue(DcmItem& item, const DcmTagKey& tag, int absent) {
    Sint32 value = 0;
    return item.findAndGetSint32(tag, value).good() ? int(value) : absent;
}

std::string text(DcmItem& item, const DcmTagKey& tag) {
    OFString value;
    item.findAndGetOFStringArray(tag, value);
    std::string result(value.c_str(), std::min(value.size(), kLongestText));
    // A cut may fall into the middle of a UTF-8 character.
    while (result.size() == kLongestText && (result.back() & 0xC0) == 0x80)
        result.pop_back();
    const auto end = result.find_last_not_of(" \0");
    result.resize(end == std::string::npos ? 0 : end + 1);
    return result;
}

}  // namespace pdr::dicom
