#include "app/presenters/light_presenter.h"

namespace pdr::app {

LightPresenter::LightPresenter(const Workspace& workspace)
    : Presenter(workspace), panel_(new ui::LightPanel), edits_(document()) {
    window().addPanel(panel_, {"Light", ui::WindowDocks::tr("Light"), Qt::Key_F8});
    connect(panel_, &ui::LightPanel::lightingEdited, &edits_, &LightEdits::setLighting);
    window().viewport().tools().bind(Qt::RightButton, Qt::ShiftModifier, drag_);
    connect(&drag_, &ui::DragTool::dragged, &edits_, [this](QPointF, QPointF step, bool moving) {
        if (document().hasVolume())
            edits_.turn(step, moving);
    });
    connectSky();
    connectModel();
}

void LightPresenter::connectSky() {
    connect(&window(), &ui::MainWindow::skyDropped, &sky_, &SkyJob::read);
    connect(panel_, &ui::LightPanel::skyChosen, &sky_, &SkyJob::read);
    showProgressOf(sky_);
    connect(&sky_, &SkyJob::failed, this, &LightPresenter::showError);
    connect(&sky_, &SkyJob::found, &edits_, &LightEdits::setSky);
}

void LightPresenter::connectModel() {
    connect(&panel_->model(), &ui::ModelChoice::modelChosen, this, &LightPresenter::chooseModel);
    connect(&trial_, &ModelTrial::measured, this, [this](Model model, Model before, double timeFactor, double levels) {
        if (model == document().setup().model)
            panel_->model().setCost(ui::ModelCost{before, timeFactor, levels});
    });
}

/// Chooses an optical model and measures what it costs and changes.
void LightPresenter::chooseModel(Model model) {
    const Model before = document().setup().model;
    document().setModel(model);
    if (document().hasVolume() && model != before)
        trial_.measure(document().scene(), before, document().display());
}

void LightPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::light | Changes::camera))
        panel_->setLighting(edits_.lighting(), document().setup().camera);
    if (has(changes, Changes::model))
        panel_->model().setModel(document().setup().model);
}

}  // namespace pdr::app
