#pragma once
/// Options that say where the parts of a patient come from: a label map, or a rule of this program.

#include <QCommandLineParser>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/parts_source.h"
#include "render/volume/label_map.h"

namespace pdr::app {

void describePartsSource(QCommandLineParser& parser);

/// Reads the options. Throws an Error that names the first wrong one; one source at most may be given.
PartsSource readPartsSource(const QCommandLineParser& parser);

/// Reads or finds the parts of a scan. `source`: there must be one; `series`: what the scan was read from, or null.
/// Errors: those of readScanLabels() and segment::findParts().
Result<LabelMap> partsFrom(const PartsSource& source, const Volume& scan, const dicom::Series* series,
                           const Progress& progress);

}  // namespace pdr::app
