#pragma once
/// The place that DICOM objects come from. Scans and loads see this interface only; import.h has the folder.

#include <filesystem>
#include <vector>

#include "dicom/series.h"
#include "render/base/named_bytes.h"
#include "render/base/progress.h"
#include "render/base/result.h"

namespace pdr::dicom {

/// A list of named objects, and the way to the bytes of each. Names are paths: objects with the same parent path lie
/// beside each other.
class SeriesSource {
  public:
    SeriesSource() = default;
    SeriesSource(const SeriesSource&) = delete;
    SeriesSource& operator=(const SeriesSource&) = delete;
    virtual ~SeriesSource() = default;

    /// Returns the path that all names begin with; notes leave it out. Empty: names are relative.
    virtual std::filesystem::path root() const = 0;

    struct Listing {
        std::vector<std::filesystem::path> names;  ///< each object once, ascending
        std::vector<Problem> problems;             ///< what could not be looked into, and may have held slices
    };
    /// Lists all objects, whether DICOM or not. Errors: the source cannot be listed or is empty; cancelled.
    virtual Result<Listing> list(const Progress& progress) const = 0;

    /// Returns the bytes of the object `name`. A file is opened only when it is read. Thread-safe. Errors: the source
    /// holds no such object (any more).
    virtual Result<NamedBytes> open(const std::filesystem::path& name) const = 0;
};

}  // namespace pdr::dicom
