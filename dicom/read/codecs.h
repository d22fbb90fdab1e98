#pragma once
/// Sets up the DICOM toolkit: quiet, tolerant where real scanners need it, all its decoders registered.

#include <string>

#include "render/base/text.h"

namespace pdr::dicom {

/// Sets up the toolkit. Must be called before any other use of it; later calls do nothing. Thread-safe.
void prepareToolkit();

/// Returns whether the toolkit has found its list of elements, a separate file (dicom.dic) that an installation can
/// lack.
bool dictionaryIsThere();

/// Returns whether pixels in this transfer syntax can be decoded.
bool canDecode(const std::string& transferSyntaxUid);

/// Returns whether pixels in this transfer syntax are compressed.
bool isCompressed(const std::string& transferSyntaxUid);

/// Returns whether pixels in this transfer syntax lie in the file with the high byte first.
bool isBigEndian(const std::string& transferSyntaxUid);

/// Returns whether this transfer syntax is one of GE's own: implicit little endian but for the pixels, which are words
/// with the high byte first (1.2.840.113619.5.2).
bool isGeBigEndian(const std::string& transferSyntaxUid);

/// Returns whether an object in this transfer syntax is deflated as a whole.
bool isDeflated(const std::string& transferSyntaxUid);

/// Returns whether this transfer syntax is JPEG 2000 or High-Throughput JPEG 2000, which the toolkit does not decode.
bool isJpeg2000(const std::string& transferSyntaxUid);

/// Returns whether this transfer syntax may have lost something, but need not: images say so themselves.
bool codingMayLose(const std::string& transferSyntaxUid);

/// Returns whether pixels in this transfer syntax differ from what was measured.
bool codingIsLossy(const std::string& transferSyntaxUid);

/// Returns the name of a transfer syntax: "JPEG 2000 (lossless only)", or the UID itself if it is unknown.
std::string transferSyntaxName(const std::string& transferSyntaxUid);

/// Returns the short name of a transfer syntax, for a list: "uncompressed", "JPEG 2000"; that of transferSyntaxName()
/// if it is none that can be decoded.
Text codingName(const std::string& transferSyntaxUid);

}  // namespace pdr::dicom
