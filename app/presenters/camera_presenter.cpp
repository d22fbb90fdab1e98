#include "app/presenters/camera_presenter.h"

#include "app/document/background_colour.h"
#include "ui/text/room_text.h"

namespace pdr::app {

CameraPresenter::CameraPresenter(const Workspace& workspace) : Presenter(workspace), panel_(new ui::CameraPanel) {
    window().addPanel(panel_, {"Camera", ui::WindowDocks::tr("Camera"), Qt::Key_F7});
    connect(panel_, &ui::CameraPanel::viewChosen, &document(), &Document::setView);
    connect(panel_, &ui::CameraPanel::cameraEdited, &document(),
            [this](const Camera& camera) { document().setCamera(camera, false); });
    connect(panel_, &ui::CameraPanel::backgroundChosen, this, &CameraPresenter::setBackground);
    connectFocus();
}

void CameraPresenter::connectFocus() {
    window().viewport().tools().add(pick_);
    connect(panel_, &ui::CameraPanel::pickingChosen, &pick_, &ui::PickTool::setActive);
    connect(&pick_, &ui::PickTool::activeChanged, panel_, &ui::CameraPanel::setPicking);
    connect(&pick_, &ui::PickTool::picked, this, &CameraPresenter::focusAt);
    connect(&study_, &TissueStudy::depthFound, &document(), &Document::setFocus);
    for (const auto remark : {&TissueStudy::layerTaken, &TissueStudy::nothingFound})
        connect(&study_, remark, this,
                [this](const Text& text) { window().status().showForAWhile(ui::sentence(text)); });
}

void CameraPresenter::focusAt(QPointF place) {
    if (document().hasVolume())
        study_.measureDepth(document().scene(), place);
}

void CameraPresenter::setBackground(const std::optional<QColor>& colour) {
    const Display display = document().display();
    document().setBackground(colour ? std::optional(radianceShownAs(*colour, display)) : std::nullopt);
}

/// Returns the background's colour on the screen; none if the environment is visible.
std::optional<QColor> CameraPresenter::background() const {
    const ImageSetup& setup = document().setup();
    if (!setup.background && setup.look.environment.visible)
        return std::nullopt;
    return shownColour(setup.background.value_or(vec3(0)), document().display());
}

void CameraPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series))
        panel_->setEnabled(document().hasVolume());
    if (has(changes, Changes::camera))
        panel_->setCamera(document().setup().camera);
    if (has(changes, Changes::background | Changes::brightness | Changes::look))
        panel_->setBackground(background());
}

}  // namespace pdr::app
