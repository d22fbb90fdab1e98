#pragma once
/// Options of `pdrender-cli parts`.

#include <QStringList>

#include <filesystem>
#include <string>

#include "app/cli/parts/parts_source.h"
#include "render/base/result.h"

namespace pdr::app {

struct PartsOptions {
    std::filesystem::path scan;  ///< a DICOM folder, an archive, a volume file or a scene file
    std::string seriesUid;       ///< empty: the first series that can be loaded
    PartsSource source;
    std::filesystem::path output;  ///< where to write the parts on the scan's grid; empty: nowhere
    bool json = false;
    bool help = false;
};

/// Parses the arguments after the word `parts`. Errors are usage errors and name the option in `where`.
Result<PartsOptions> partsOptions(const QStringList& arguments);

/// Returns the text for --help.
std::string partsHelp();

}  // namespace pdr::app
