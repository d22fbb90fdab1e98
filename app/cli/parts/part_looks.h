#pragma once
/// Options that give parts of the patient a look of their own: where the parts come from, and the curve of each.

#include <QCommandLineParser>

#include <string>
#include <vector>

#include "app/cli/parts/parts_source.h"
#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/named_look.h"
#include "render/scene/part_styles.h"
#include "render/scene/parts.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// The look of the parts of one name.
struct PartLook {
    std::string part;
    NamedLook look;
};

struct PartLooks {
    PartsSource source;
    std::vector<PartLook> looks;  ///< empty: parts are shown as the look of the scene says
};

void describePartLooks(QCommandLineParser& parser);

/// Reads the options. Throws an Error that names the first wrong one.
PartLooks readPartLooks(const QCommandLineParser& parser);

/// Reads or finds the parts of the scan of `scene`, and returns the scene in which they are shown as `styles`, those of
/// its look, say, but those that are named have the curve of their look; parts of one name get the same. `series`: what
/// the scan was read from, or null. Errors: those of reading or finding parts; a name that no part has.
Result<Scene> withPartLooks(Scene scene, const PartLooks& wanted, const PartStyles& styles, const dicom::Series* series,
                            const Progress& progress);
/// Reads or finds the parts that have `curves` in a scene file. Errors: those of reading or finding parts; a label that
/// no part has.
Result<Parts> partsOfFile(const PartsSource& source, std::vector<PartCurve> curves, const Volume& scan,
                          const dicom::Series* series, const Progress& progress);

}  // namespace pdr::app
