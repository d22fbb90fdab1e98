#include "app/cli/parts/part_looks.h"

#include <algorithm>
#include <utility>

#include "app/cli/scene/look_option.h"
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

/// Puts the curve of a label in place of the one that it has, in the order of the labels.
void setCurve(std::vector<PartCurve>& curves, PartCurve curve) {
    const auto at = std::ranges::lower_bound(curves, curve.label, {}, &PartCurve::label);
    if (at != curves.end() && at->label == curve.label)
        *at = std::move(curve);
    else
        curves.insert(at, std::move(curve));
}

/// Sets the curves of the labels whose part has a look.
void setCurves(std::vector<PartCurve>& curves, const LabelMap& map, const std::vector<PartLook>& looks) {
    for (std::size_t n = 0; n < map.parts.size(); ++n) {
        const auto look = std::ranges::find(looks, map.parts[n].name, &PartLook::part);
        if (look != looks.end())
            setCurve(curves, {std::uint8_t(n + 1), look->look.look.transferFunction, look->look.look.gradientFactor});
    }
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
    if (!wanted.looks.empty() && !wanted.source.isGiven())
        usageError("--part", "needs to know where the parts come from", "Add --labels FILE or --find vessels.");
    return wanted;
}

Result<Scene> withPartLooks(Scene scene, const PartLooks& wanted, const PartStyles& styles, const dicom::Series* series,
                            const Progress& progress) {
    Result<LabelMap> found = partsFrom(wanted.source, *scene.volume, series, progress);
    if (!found)
        return found.error();
    for (const PartLook& look : wanted.looks)
        if (std::ranges::find(found->parts, look.part, &MappedPart::name) == found->parts.end())
            return Error{"no part has the name \"" + look.part + "\"", "--part", "There are: " + namesOf(*found) + "."};
    const auto map = std::make_shared<const LabelMap>(*std::move(found));
    scene = withParts(std::move(scene), map, styles);
    setCurves(scene.parts.curves, *map, wanted.looks);
    scene.parts.map = map;
    return scene;
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
