#include "app/presenters/region_presenter.h"

namespace pdr::app {

RegionPresenter::RegionPresenter(const Workspace& workspace)
    : Presenter(workspace), box_(new ui::RegionBox(&window().viewport())), action_(window().menuActions().boxFirst) {
    connect(action_, &QAction::triggered, this, &RegionPresenter::drawOrForget);
    connect(box_, &ui::RegionBox::drawn, this, &RegionPresenter::choose);
    connect(box_, &ui::RegionBox::notDrawn, action_, [this] { action_->setChecked(false); });
}

void RegionPresenter::showDocument(Changes changes) {
    if (!has(changes, Changes::series))
        return;
    choose(std::nullopt);
    action_->setEnabled(document().hasVolume());
}

void RegionPresenter::choose(const std::optional<QRectF>& region) {
    action_->setChecked(region.has_value());
    box_->setBox(region);
    bridge().setRegion(region);
}

/// Starts to draw a region with the next drag, or removes the region.
void RegionPresenter::drawOrForget(bool draw) {
    box_->stopDrawing();
    if (draw)
        box_->startDrawing();
    else
        choose(std::nullopt);
}

}  // namespace pdr::app
