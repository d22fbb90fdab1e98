#include "app/presenters/cut_presenter.h"

namespace pdr::app {

CutPresenter::CutPresenter(const Workspace& workspace)
    : Presenter(workspace), tools_(new ui::CutTools(&window().viewport())), edits_(document()) {
    const QAction* toggle = window().addPanel(&tools_->panel(), {"Cut", ui::WindowDocks::tr("Cut"), Qt::Key_F9});
    window().addMenu(ui::MainWindow::tr("&Cut"), [this](QMenu& menu) { tools_->fillMenu(menu); });
    connect(&window(), &ui::MainWindow::cancelRequested, tools_, &ui::CutTools::hideHandles);
    connect(toggle, &QAction::triggered, tools_, [this](bool shown) {
        if (shown)
            tools_->showHandles();
    });
    connect(&tools_->layer(), &ui::CutLayer::clipEdited, &document(), &Document::setClip);
    connect(&tools_->layer(), &ui::CutLayer::gestureGivenUp, &document(), &Document::giveUpGesture);
    connect(&tools_->panel(), &ui::CutPanel::clipChosen, &document(),
            [this](const Clip& clip) { document().setClip(clip); });
    connect(tools_, &ui::CutTools::planeWanted, &edits_, &CutEdits::addPlane);
    connect(&tools_->pen(), &ui::FreehandPen::drawn, &edits_, &CutEdits::addFreehand);
    connect(tools_, &ui::CutTools::uncutWanted, &edits_, &CutEdits::undoAll);
}

void CutPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::clip | Changes::table | Changes::series))
        tools_->setCuts(document().setup().clip, document().uncut());
}

}  // namespace pdr::app
