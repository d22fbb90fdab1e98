#include "app/presenters/tissue_presenter.h"

#include "ui/text/room_text.h"

namespace pdr::app {

TissuePresenter::TissuePresenter(const Workspace& workspace)
    : Presenter(workspace), panel_(new ui::TissuePanel), edits_(document()) {
    window().addPanel(panel_, {"Tissue", ui::WindowDocks::tr("Tissue"), Qt::Key_F5});
    connect(panel_, &ui::TissuePanel::transferFunctionEdited, &edits_, &TissueEdits::setTransferFunction);
    connect(&study_, &TissueStudy::histogramFound, panel_, &ui::TissuePanel::setHistogram);
    connectTools();
}

void TissuePresenter::connectTools() {
    ui::ViewTools& tools = window().viewport().tools();
    tools.bind(Qt::LeftButton, Qt::ControlModifier, drag_);
    tools.add(pick_);
    connect(&drag_, &ui::DragTool::dragged, &edits_,
            [this](QPointF total, QPointF, bool moving) { edits_.drag(total, moving); });
    connect(&drag_, &ui::DragTool::clicked, this, &TissuePresenter::pick);
    connect(&pick_, &ui::PickTool::picked, this, &TissuePresenter::pick);
    connect(panel_, &ui::TissuePanel::pickingChosen, &pick_, &ui::PickTool::setActive);
    connect(&pick_, &ui::PickTool::activeChanged, panel_, &ui::TissuePanel::setPicking);
    connect(&study_, &TissueStudy::tissueFound, &edits_, &TissueEdits::addBell);
    for (const auto remark : {&TissueStudy::layerTaken, &TissueStudy::nothingFound})
        connect(&study_, remark, this,
                [this](const Text& text) { window().status().showForAWhile(ui::sentence(text)); });
}

void TissuePresenter::pick(QPointF place) {
    if (document().hasVolume())
        study_.pick(document().scene(), place);
}

void TissuePresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series) && document().hasVolume())
        showVolume();
    if (has(changes, Changes::tissue | Changes::looks))
        panel_->setTransferFunction(document().setup().look.transferFunction);
}

void TissuePresenter::showFrame(const std::shared_ptr<const Frame>&) {
    afterImage_.imageStands();
}

void TissuePresenter::showVolume() {
    panel_->setValues(unitOf(*document().seen()));
    afterImage_.call([this] { study_.setVolume(document().seen()); });
}

void TissuePresenter::releaseVolume() {
    afterImage_.reset();
    study_.setVolume(nullptr);
    panel_->setHistogram(nullptr);
}

}  // namespace pdr::app
