#include "app/cli/parts/parts_source.h"

#include "app/command_line/option_reader.h"
#include "app/scan/scan_labels.h"

namespace pdr::app {

void describePartsSource(QCommandLineParser& parser) {
    parser.addOptions({
        {"labels",
         "Parts of the patient from a label map: NIfTI, NRRD (also .seg.nrrd), MetaImage or a DICOM segmentation, or a "
         "folder with a mask of each part.",
         "FILE|FOLDER"},
        {"find",
         "Find parts in the scan itself, by rules that may err: vessels, on a scan with contrast medium, skin and "
         "muscle (shells), bone that the other side has (mirror), implants (metal), or several: vessels,shells.",
         "RULES"},
        {"resample",
         "If the label map has other voxels than the scan, give each voxel of the scan the label of the nearest one."},
    });
}

PartsSource readPartsSource(const QCommandLineParser& parser) {
    const Reader reader(parser);
    PartsSource source;
    source.labels = reader.text("labels").value_or("").toStdString();
    source.resampling = parser.isSet("resample") ? Resampling::nearest : Resampling::refused;
    if (parser.isSet("find")) {
        Result<segment::PartRules> rules = segment::partRulesFrom(reader.text("find").value_or("").toStdString());
        if (!rules)
            usageError("--find", rules.error().what);
        source.rules = *std::move(rules);
    }
    if (!source.labels.empty() && source.finds())
        usageError("--find", "and --labels both say where the parts come from", "Give one of them.");
    return source;
}

Result<LabelMap> partsFrom(const PartsSource& source, const Volume& scan, const dicom::Series* series,
                           const Progress& progress) {
    if (source.finds())
        return segment::findParts(source.rules, scan, progress);
    return readScanLabels(source.labels, scan.geometry(), series, source.resampling, progress);
}

}  // namespace pdr::app
