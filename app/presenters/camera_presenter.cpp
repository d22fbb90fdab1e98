#include "app/presenters/camera_presenter.h"

#include "app/document/background_colour.h"

namespace pdr::app {

using Picking = ui::Viewport::Picking;

CameraPresenter::CameraPresenter(const Workspace& workspace) : Presenter(workspace), panel_(new ui::CameraPanel) {
    window().addPanel(panel_, {"Camera", ui::WindowDocks::tr("Camera"), Qt::Key_F7, ui::PanelPlace::editor});
    connect(panel_, &ui::CameraPanel::viewChosen, &document(), &Document::setView);
    connect(panel_, &ui::CameraPanel::cameraEdited, &document(),
            [this](const Camera& camera) { document().setCamera(camera, false); });
    connect(panel_, &ui::CameraPanel::backgroundChosen, this, &CameraPresenter::setBackground);
    connectFocus();
}

void CameraPresenter::connectFocus() {
    ui::Viewport& view = window().viewport();
    connect(panel_, &ui::CameraPanel::pickingChosen, &view,
            [&view](bool picking) { view.setPicking(picking ? Picking::focus : Picking::nothing); });
    connect(&view, &ui::Viewport::pickingChanged, panel_,
            [this](Picking picking) { panel_->setPicking(picking == Picking::focus); });
    connect(&view, &ui::Viewport::focusPicked, this, [this](QPointF place) {
        if (document().hasVolume())
            study_.measureDepth(document().scene(), place);
    });
    connect(&study_, &TissueStudy::depthFound, &document(), &Document::setFocus);
    connect(&study_, &TissueStudy::nothingFound, this,
            [this] { window().status().showForAWhile(ui::MainWindow::tr("No tissue at this point")); });
}

void CameraPresenter::setBackground(const std::optional<QColor>& colour) {
    const Display display = document().display();
    document().setBackground(colour ? std::optional(radianceShownAs(*colour, display)) : std::nullopt);
}

/// Returns the background's colour on the screen; none if the environment is visible.
std::optional<QColor> CameraPresenter::background() const {
    const PictureSetup& setup = document().setup();
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
