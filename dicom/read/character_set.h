#pragma once
/// Text in a character set that the DICOM toolkit cannot convert.

#include <string>

namespace pdr::dicom {

/// `raw` as UTF-8 where `characterSet` (SpecificCharacterSet) is the Japanese one with escape sequences, which Debian's
/// toolkit lacks; otherwise its ASCII, with a question mark for everything else. Never a control character.
std::string readable(const std::string& raw, const std::string& characterSet);

}  // namespace pdr::dicom
