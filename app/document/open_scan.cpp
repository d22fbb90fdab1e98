#include "app/document/open_scan.h"

namespace pdr::app {

OpenScan::OpenScan(std::shared_ptr<const Volume> volume, segment::HiddenTable table,
                   std::shared_ptr<const HiddenVoxels> hidden)
    : volume_(std::move(volume)),
      table_(std::move(table)),
      hidden_(std::move(hidden)),
      bodyParts_(std::make_shared<const segment::BodyParts>(volume_)) {}

std::shared_ptr<const Volume> OpenScan::seen(Table table) const {
    if (table == Table::hidden || !hasTable())
        return volume_;
    std::shared_ptr<const Volume> scan = withTable_.lock();
    if (!scan)
        withTable_ = scan = std::make_shared<const Volume>(hidden_->scanOf(*volume_));
    return scan;
}

Framed OpenScan::framed(Table table) const {
    if (table == Table::hidden)
        return {table_.bodyBox, table_.outlineMm};
    return {volume_->geometry(), nullptr};
}

/// Returns the volume of the scene: what is seen, with less noise if that is wanted and known.
std::shared_ptr<const Volume> OpenScan::shown(const ImageSetup& setup) const {
    std::shared_ptr<const Volume> scan = seen(setup.table);
    std::shared_ptr<const Volume> denoised = setup.look.ctDenoised ? denoised_.of(scan) : nullptr;
    return denoised ? denoised : scan;
}

Scene OpenScan::sceneOf(const Plan& plan, ivec2 film) {
    const Visible& visible = plan.image.look.visible;
    masks_.show(visible);
    parts_.show(plan.partSources);
    const std::shared_ptr<const ScanParts>& parts = parts_.parts();
    Scene scene = pdr::sceneOf(plan.image, shown(plan.image), film, parts ? parts->map : nullptr);
    scene.mask = masks_.mask();
    scene.maskAwaited = masks_.shown() != visible || parts_.shown() != plan.partSources;
    return scene;
}

}  // namespace pdr::app
