#pragma once
/// The bytes of one DICOM object and the name by which messages call it.

#include "render/base/named_bytes.h"

namespace pdr::dicom {

using pdr::NamedBytes;

}  // namespace pdr::dicom
