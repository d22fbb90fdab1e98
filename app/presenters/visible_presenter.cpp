#include "app/presenters/visible_presenter.h"

#include "render/scene/not_shown.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

/// Returns what the image hides, in sentences, or that the mask of the chosen part is still being made.
QString notShownText(const Scene& scene) {
    if (scene.maskAwaited)
        return ui::MainWindow::tr("Still being separated; everything is shown until then.");
    return ui::inWords(notShown(scene));
}

}  // namespace

VisiblePresenter::VisiblePresenter(const Workspace& workspace, ui::VisibleRow& row) : Presenter(workspace), row_(row) {
    connect(&row_, &ui::VisibleRow::chosen, &document(),
            [this](const Visible& visible) { document().setVisible(visible); });
    connectMasks();
}

void VisiblePresenter::connectMasks() {
    showProgressOf(masks_);
    connect(&document(), &Document::maskWanted, this,
            [this](const std::shared_ptr<const segment::BodyParts>& parts, const Visible& visible) {
                afterImage_.call([this, parts, visible] { masks_.make(parts, visible); });
            });
    connect(&masks_, &MaskJob::made, &document(), &Document::setMask);
    connect(&masks_, &MaskJob::cancelled, &document(), &Document::keepVisible);
    connect(&masks_, &MaskJob::refused, this, [this](const Visible& visible, const Error& error) {
        document().setMask(visible, nullptr);
        showError(error);
    });
    connect(&masks_, &MaskJob::failed, this, [this](const Error& error) {
        document().keepVisible();
        showError(error);
    });
}

void VisiblePresenter::showDocument(Changes changes) {
    if (!has(changes, Changes::look | Changes::model | Changes::mask | Changes::partSources | Changes::series))
        return;
    row_.setChoice(document().setup().look.visible);
    row_.setNotShown(notShownText(document().scene()));
}

void VisiblePresenter::showFrame(const std::shared_ptr<const Frame>&) {
    afterImage_.imageStands();
}

void VisiblePresenter::releaseVolume() {
    afterImage_.reset();
    masks_.cancel();
}

}  // namespace pdr::app
