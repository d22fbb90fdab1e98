#pragma once
/// The DICOM toolkit, made ready once: quiet, tolerant where real scanners need it, all its decoders registered.

#include <string>

namespace pdr::dicom {

/// Call before any other use of the toolkit; later calls do nothing. Safe from any thread.
void prepareToolkit();

/// Whether the toolkit has found its list of elements, a file beside it (dicom.dic) that an installation can lack.
bool dictionaryIsThere();

/// Whether pixels in this transfer syntax can be decoded.
bool canDecode(const std::string& transferSyntaxUid);

/// Whether pixels in this transfer syntax take less room than their size says.
bool isCompressed(const std::string& transferSyntaxUid);

/// Whether pixels in this transfer syntax may differ from what was measured.
bool codingIsLossy(const std::string& transferSyntaxUid);

/// "JPEG 2000 (Lossless only)", or the UID itself where it is not a known one.
std::string transferSyntaxName(const std::string& transferSyntaxUid);

}  // namespace pdr::dicom
