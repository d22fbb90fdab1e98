#include "app/cli/part_looks.h"

#include <algorithm>

#include "app/cli/look_option.h"
#include "app/command_line/option_reader.h"

namespace pdr::app {
namespace {

PartLook readPart(const QString& text) {
    const qsizetype at = text.indexOf('=');
    if (at < 1)
        usageError("--part", "must look like \"vessels=Vessels\": the name of a part, and a look");
    return {text.left(at).toStdString(), namedLook(text.mid(at + 1), "--part")};
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
            curves.push_back({std::uint8_t(n + 1), look->look.look.transferFunction, look->look.look.gradientFactor});
    }
    return curves;
}

}  // namespace

void describePartLooks(QCommandLineParser& parser) {
    describePartsSource(parser);
    parser.addOptions({
        {"part",
         "The look of the part of that name: its curve and colours; may be given several times. All other tissue has "
         "that of --look.",
         "NAME=LOOK"},
    });
}

PartLooks readPartLooks(const QCommandLineParser& parser) {
    PartLooks wanted{readPartsSource(parser), {}};
    for (const QString& part : parser.values("part"))
        wanted.looks.push_back(readPart(part));
    if (wanted.looks.empty() == wanted.source.isGiven())
        usageError("--part", "gives parts a look, and --labels or --find says where they come from",
                   "Give both, or neither.");
    return wanted;
}

Result<Parts> partsWithLooks(const PartLooks& wanted, const Volume& scan, const dicom::Series* series,
                             const Progress& progress) {
    Result<LabelMap> map = partsFrom(wanted.source, scan, series, progress);
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

Result<Parts> partsOfFile(const PartsSource& source, std::vector<PartCurve> curves, const Volume& scan,
                          const dicom::Series* series, const Progress& progress) {
    Result<LabelMap> map = partsFrom(source, scan, series, progress);
    if (!map)
        return map.error();
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (curves[i].label > map->parts.size())
            return Error{"there is no part " + std::to_string(curves[i].label) + " among the " +
                             std::to_string(map->parts.size()) + " of the label map",
                         "parts.materials[" + std::to_string(i) + "].label",
                         "\"pdrender-cli parts\" lists the numbers of the parts."};
    return Parts{std::make_shared<const LabelMap>(*std::move(map)), std::move(curves)};
}

}  // namespace pdr::app
