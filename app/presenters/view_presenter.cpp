#include "app/presenters/view_presenter.h"

#include "ui/text/room_text.h"

namespace pdr::app {

ViewPresenter::ViewPresenter(const Workspace& workspace) : Presenter(workspace) {
    const ui::WindowActions& actions = window().menuActions();
    connectViews();
    connect(&window().viewport(), &ui::Viewport::sizeInPixelsChanged, this, &ViewPresenter::keepOrFitFilm);
    connect(actions.fit, &QAction::triggered, this, &ViewPresenter::fitFilm);
    connect(actions.table, &QAction::triggered, &document(),
            [this](bool shown) { document().setTable(shown ? Table::shown : Table::hidden); });
    connect(actions.denoised, &QAction::triggered, &document(), &Document::setDenoised);
    connect(actions.undo, &QAction::triggered, &document(), &Document::undo);
    connect(actions.redo, &QAction::triggered, &document(), &Document::redo);
}

void ViewPresenter::connectViews() {
    const ui::WindowActions& actions = window().menuActions();
    connect(&window().viewport(), &ui::Viewport::cameraEdited, &document(), &Document::setCamera);
    for (std::size_t i = 0; i < actions.views.size(); ++i)
        connect(actions.views[i], &QAction::triggered, &document(), [this, i] { document().setView(StandardView(i)); });
    connect(actions.firstView, &QAction::triggered, &document(), &Document::resetView);
}

ivec2 ViewPresenter::viewSize() const {
    const QSize view = window().viewport().sizeInPixels();
    return {view.width(), view.height()};
}

/// Follows the view's size. An image on the screen keeps its size and its samples; it is stretched.
void ViewPresenter::keepOrFitFilm() {
    const auto& frame = bridge().lastFrame();
    if (frame && !frame->coarse)
        document().setNextFilm(viewSize());
    else
        document().setViewSize(viewSize());
}

void ViewPresenter::fitFilm() {
    document().setViewSize(viewSize());
}

void ViewPresenter::showDocument(Changes changes) {
    const Document& shown = document();
    const ui::WindowActions& actions = window().menuActions();
    window().viewport().setCamera(shown.hasVolume() ? std::optional(shown.setup().camera) : std::nullopt);
    if (has(changes, Changes::table) && shown.setup().table == Table::shown)
        window().message().withdraw(ui::MainWindow::tr("Show"));
    actions.table->setChecked(shown.setup().table == Table::shown);
    actions.table->setEnabled(shown.hasTable());
    actions.denoised->setChecked(shown.denoised());
    actions.undo->setEnabled(shown.canUndo());
    actions.undo->setText('&' + ui::inWords(shown.undoText()));
    actions.redo->setEnabled(shown.canRedo());
    actions.redo->setText('&' + ui::inWords(shown.redoText()));
    for (QAction* view : actions.views)
        view->setEnabled(shown.hasVolume());
    for (QAction* action : {actions.firstView, actions.fit, actions.denoised})
        action->setEnabled(shown.hasVolume());
}

}  // namespace pdr::app
