#include "app/cli/part_looks.h"

#include <algorithm>

#include "app/cli/look_option.h"
#include "app/command_line/option_reader.h"
#include "app/scan/scan_labels.h"
#include "render/segment/shells.h"
#include "render/segment/vessels.h"

namespace pdr::app {
namespace {

PartLook readPart(const QString& text) {
    const qsizetype at = text.indexOf('=');
    if (at < 1)
        usageError("--part", "must look like \"vessels=Arteries\": the name of a part, and a look");
    return {text.left(at).toStdString(), namedLook(text.mid(at + 1), "--part")};
}

Result<LabelMap> mapOf(const PartLooks& wanted, const Volume& scan, const dicom::Series* series,
                       const Progress& progress) {
    if (wanted.findsVessels)
        return segment::findVessels(scan, progress);
    if (wanted.findsShells)
        return segment::findShells(scan, nullptr, progress);
    return readScanLabels(wanted.labels, scan.geometry(), series, wanted.resampling, progress);
}

/// Returns the names of all parts: "aorta, heart".
std::string namesOf(const LabelMap& map) {
    std::string names;
    for (const MappedPart& part : map.parts)
        names += (names.empty() ? "" : ", ") + part.name;
    return names;
}

/// Returns the curves of the labels whose part has a look, in the order of the labels.
std::vector<PartCurve> curvesOf(const LabelMap& map, const std::vector<PartLook>& looks) {
    std::vector<PartCurve> curves;
    for (std::size_t n = 0; n < map.parts.size(); ++n) {
        const auto look = std::ranges::find(looks, map.parts[n].name, &PartLook::part);
        if (look != looks.end())
            curves.push_back({std::uint8_t(n + 1), look->look.look.transferFunction});
    }
    return curves;
}

}  // namespace

void describePartLooks(QCommandLineParser& parser) {
    parser.addOptions({
        {"labels", "Parts of the patient with a look of their own: a label map, as for `pdrender-cli parts`.", "FILE"},
        {"find", "Find such parts in the scan itself, by rules that may err: vessels or shells.", "PARTS"},
        {"resample", "If the label map has other voxels than the scan, each takes the label of the nearest one."},
        {"part",
         "The look of the part of that name: its curve and colours; may be given several times. All other tissue has "
         "that of --look.",
         "NAME=LOOK"},
    });
}

PartLooks readPartLooks(const QCommandLineParser& parser) {
    const Reader reader(parser);
    PartLooks wanted;
    wanted.labels = reader.text("labels").value_or("").toStdString();
    wanted.resampling = parser.isSet("resample") ? Resampling::nearest : Resampling::refused;
    const QString find = reader.text("find").value_or("");
    wanted.findsVessels = find == "vessels";
    wanted.findsShells = find == "shells";
    const bool finds = wanted.findsVessels || wanted.findsShells;
    if (!find.isEmpty() && !finds)
        usageError("--find", "must be vessels or shells, not \"" + find.toStdString() + "\"");
    if (!wanted.labels.empty() && finds)
        usageError("--find", "and --labels both say where the parts come from", "Give one of them.");
    for (const QString& part : parser.values("part"))
        wanted.looks.push_back(readPart(part));
    if (wanted.looks.empty() != (wanted.labels.empty() && !finds))
        usageError("--part", "gives parts a look, and --labels or --find says where they come from",
                   "Give both, or neither.");
    return wanted;
}

Result<Parts> partsWithLooks(const PartLooks& wanted, const Volume& scan, const dicom::Series* series,
                             const Progress& progress) {
    Result<LabelMap> map = mapOf(wanted, scan, series, progress);
    if (!map)
        return map.error();
    for (const PartLook& look : wanted.looks)
        if (std::ranges::find(map->parts, look.part, &MappedPart::name) == map->parts.end())
            return Error{"no part has the name \"" + look.part + "\"", "--part", "There are: " + namesOf(*map) + "."};
    Parts parts;
    parts.curves = curvesOf(*map, wanted.looks);
    parts.map = std::make_shared<const LabelMap>(*std::move(map));
    return parts;
}

}  // namespace pdr::app
