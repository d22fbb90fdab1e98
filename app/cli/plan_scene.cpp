#include "app/cli/plan_scene.h"

#include "render/scene/visible_mask.h"

namespace pdr::app {

const std::shared_ptr<const Volume>& volumeOf(const Plan& plan, const ScannedVolume& scanned) {
    return plan.image.table == Table::shown ? scanned.volume : scanned.seen;
}

Result<LoadedScene> sceneOfPlan(const Plan& plan, const ScannedVolume& scanned, ivec2 film, const Progress& progress) {
    const ImageSetup& image = plan.image;
    if (!plan.partSources.empty() && !image.look.parts.empty())
        return Error{phrase("the plan shows parts of the scan, which only the window can show"), "",
                     phrase("Open the plan there, and save its image."), ErrorKind::refused};
    LoadedScene work{sceneOf(image, volumeOf(plan, scanned), film), displayOf(image), {}, scanned.files, {}, {}};
    const bool whole = image.table == Table::shown;
    work.uncut = boxAround(whole ? scanned.volume->geometry() : scanned.body);
    work.series = scanned.series;
    // Parts are found without the table, as in the window
    const segment::BodyParts parts(scanned.seen);
    const auto mask = visibleMask(parts, work.scene.visible, parts.volume().geometry(), progress);
    if (!mask)
        return mask.error();
    work.scene.mask = *mask;
    if (*mask)
        work.notes.push_back((*mask)->hidden());
    if (auto ok = denoiseCt(work, progress); !ok)
        return ok.error();
    if (auto ok = work.scene.check(); !ok)
        return ok.error();
    return work;
}

}  // namespace pdr::app
