#include "dicom/read/character_set.h"

#include <iconv.h>

#include <algorithm>

namespace pdr::dicom {

namespace {

/// Converts Japanese text: the escape sequences of DICOM's ISO 2022 IR 87 and 159 are those of ISO-2022-JP-2. Empty on
/// failure.
std::string fromJapanese(std::string raw) {
    const iconv_t converter = iconv_open("UTF-8", "ISO-2022-JP-2");
    if (converter == iconv_t(-1))
        return {};
    std::string utf8(raw.size() * 4 + 16, '\0');
    char *in = raw.data(), *out = utf8.data();
    std::size_t inLeft = raw.size(), outLeft = utf8.size();
    const bool converted = iconv(converter, &in, &inLeft, &out, &outLeft) != std::size_t(-1) && inLeft == 0;
    iconv_close(converter);
    utf8.resize(converted ? utf8.size() - outLeft : 0);
    return utf8;
}

}  // namespace

std::string readable(const std::string& raw, const std::string& characterSet) {
    const bool isJapanese = characterSet.find("ISO 2022 IR 87") != std::string::npos ||
                            characterSet.find("ISO 2022 IR 159") != std::string::npos;
    std::string text = isJapanese ? fromJapanese(raw) : std::string();
    const bool converted = !text.empty();
    if (!converted)
        text = raw;
    std::replace_if(
        text.begin(), text.end(), [&](unsigned char c) { return c < 0x20 || c == 0x7F || (c >= 0x80 && !converted); },
        '?');
    return text;
}

}  // namespace pdr::dicom
