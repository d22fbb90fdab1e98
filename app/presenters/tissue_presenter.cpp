#include "app/presenters/tissue_presenter.h"

namespace pdr::app {

using Picking = ui::Viewport::Picking;

TissuePresenter::TissuePresenter(const Workspace& workspace)
    : Presenter(workspace), panel_(new ui::TissuePanel), edits_(document()) {
    window().addPanel(panel_, {"Tissue", ui::WindowDocks::tr("Tissue"), Qt::Key_F5, ui::PanelPlace::editor});
    connect(panel_, &ui::TissuePanel::transferFunctionEdited, &edits_, &TissueEdits::setTransferFunction);
    connect(&window().viewport(), &ui::Viewport::tissueDragged, &edits_, &TissueEdits::drag);
    connect(&study_, &TissueStudy::histogramFound, panel_, &ui::TissuePanel::setHistogram);
    connectPicking();
}

void TissuePresenter::connectPicking() {
    ui::Viewport& view = window().viewport();
    connect(panel_, &ui::TissuePanel::pickingChosen, &view,
            [&view](bool picking) { view.setPicking(picking ? Picking::tissue : Picking::nothing); });
    connect(&view, &ui::Viewport::pickingChanged, panel_,
            [this](Picking picking) { panel_->setPicking(picking == Picking::tissue); });
    connect(&view, &ui::Viewport::tissuePicked, this, [this](QPointF place) {
        if (document().hasVolume())
            study_.pick(document().scene(), place);
    });
    connect(&study_, &TissueStudy::tissueFound, &edits_, &TissueEdits::addBell);
    connect(&study_, &TissueStudy::nothingFound, this,
            [this] { window().status().showForAWhile(ui::MainWindow::tr("No tissue at this point")); });
}

void TissuePresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series) && document().hasVolume())
        study_.setVolume(document().seen());
    if (has(changes, Changes::tissue | Changes::looks))
        panel_->setTransferFunction(document().setup().look.transferFunction);
}

void TissuePresenter::releaseVolume() {
    study_.setVolume(nullptr);
    panel_->setHistogram(nullptr);
}

}  // namespace pdr::app
