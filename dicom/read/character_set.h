#pragma once
/// Converts text in character sets that the DICOM toolkit cannot convert.

#include <string>

namespace pdr::dicom {

/// Returns `raw` as UTF-8 if `characterSet` (SpecificCharacterSet) is the Japanese one with escape sequences, which
/// Debian's toolkit lacks; otherwise its ASCII, with a question mark for everything else. Never returns a control
/// character.
std::string readable(const std::string& raw, const std::string& characterSet);

}  // namespace pdr::dicom
