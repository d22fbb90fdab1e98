#include "app/cli/plan/plan_scene.h"

#include <utility>

#include "app/plan/part_maps.h"
#include "app/scan/scan_labels.h"
#include "render/scene/not_shown.h"
#include "render/scene/visible_mask.h"

namespace pdr::app {
namespace {

/// Reads the label map that a plan shows. Its hash tells whether it was resampled for that.
Result<void> addLabels(PartMaps& maps, const std::string& hash, const std::filesystem::path& file,
                       const ScannedVolume& scanned, const Progress& progress) {
    if (file.empty())
        return Error{"the plan shows parts of a label map, of which it holds neither the voxels nor the place",
                     "--labels", "Name that label map.", ErrorKind::refused};
    auto map = readScanLabels(file, scanned.seen->geometry(), scanned.series.get(), Resampling::nearest, progress);
    if (!map)
        return map.error();
    maps.setLabels(*std::move(map));
    if (maps.hash() != hash)
        return Error{"this is not the label map that the plan shows: its labels or names differ", file.string(),
                     "Name the file that was open when the plan was saved.", ErrorKind::refused};
    return {};
}

/// Returns the parts that the image of a plan shows; null: it shows none.
Result<std::shared_ptr<const LabelMap>> partsOf(const Plan& plan, const ScannedVolume& scanned,
                                                const std::filesystem::path& labels, const Progress& progress) {
    const PartSources& sources = plan.partSources;
    if (sources.labels.empty() && !labels.empty())
        return Error{"the plan shows no label map", "--labels", "Leave it out.", ErrorKind::refused};
    if (sources.empty() || plan.image.look.parts.empty())
        return std::shared_ptr<const LabelMap>();
    PartMaps maps;
    if (!sources.labels.empty())
        if (auto ok = addLabels(maps, sources.labels, labels, scanned, partOf(progress, 0, 0.3)); !ok)
            return ok.error();
    const auto parts = maps.make(sources, *scanned.seen, partOf(progress, 0.3, 1));
    if (!parts)
        return parts.error();
    return (*parts)->map;
}

}  // namespace

const std::shared_ptr<const Volume>& volumeOf(const Plan& plan, const ScannedVolume& scanned) {
    return plan.image.table == Table::shown ? scanned.volume : scanned.seen;
}

Result<LoadedScene> sceneOfPlan(const Plan& plan, const ScannedVolume& scanned, const std::filesystem::path& labels,
                                ivec2 film, const Progress& progress) {
    const ImageSetup& image = plan.image;
    const auto map = partsOf(plan, scanned, labels, partOf(progress, 0, 0.4));
    if (!map)
        return map.error();
    LoadedScene work{sceneOf(image, volumeOf(plan, scanned), film, *map), displayOf(image), {}, scanned.files, {}, {}};
    const bool whole = image.table == Table::shown;
    work.uncut = boxAround(whole ? scanned.volume->geometry() : scanned.body);
    work.series = scanned.series;
    // Parts are found without the table, as in the window
    const segment::BodyParts parts(scanned.seen);
    const auto mask = visibleMask(parts, work.scene.visible, parts.volume().geometry(), partOf(progress, 0.4, 0.6));
    if (!mask)
        return mask.error();
    work.scene.mask = *mask;
    if (*map)
        work.notes.insert(work.notes.end(), (*map)->notes.begin(), (*map)->notes.end());
    if (const Text hidden = notShown(work.scene); !hidden.empty())
        work.notes.push_back(hidden);
    if (auto ok = denoiseCt(work, partOf(progress, 0.6, 1)); !ok)
        return ok.error();
    if (auto ok = work.scene.check(); !ok)
        return ok.error();
    return work;
}

}  // namespace pdr::app
