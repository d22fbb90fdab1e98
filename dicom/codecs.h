#pragma once
/// The DICOM toolkit, made ready once: quiet, tolerant where real scanners need it, all its decoders registered.

#include <string>

namespace pdr::dicom {

/// Call before any other use of the toolkit; later calls do nothing. Safe from any thread.
void prepareToolkit();

/// Whether pixels in this transfer syntax can be decoded.
bool canDecode(const std::string& transferSyntaxUid);

/// "JPEG 2000 (Lossless only)", or the UID itself where it is not a known one.
std::string transferSyntaxName(const std::string& transferSyntaxUid);

}  // namespace pdr::dicom
