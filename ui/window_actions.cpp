#include "ui/window_actions.h"

#include <QCoreApplication>
#include <QMenu>

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(MainWindow)
};

QAction* checkable(QAction* action, const QString& toolTip = {}) {
    action->setCheckable(true);
    if (!toolTip.isEmpty())
        action->setToolTip(toolTip);
    return action;
}

void fillFileMenu(QMenuBar& bar, WindowActions& actions) {
    QMenu* menu = bar.addMenu(Texts::tr("&File"));
    actions.open = menu->addAction(Texts::tr("&Open folder..."), QKeySequence::Open);
    actions.save = menu->addAction(Texts::tr("&Save picture..."), QKeySequence::Save);
    menu->addSeparator();
    actions.quit = menu->addAction(Texts::tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q));
}

void fillEditMenu(QMenuBar& bar, WindowActions& actions) {
    QMenu* menu = bar.addMenu(Texts::tr("&Edit"));
    actions.undo = menu->addAction(Texts::tr("&Undo"), QKeySequence::Undo);
    actions.redo = menu->addAction(Texts::tr("&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    menu->addSeparator();
    actions.copy = menu->addAction(Texts::tr("&Copy picture"), QKeySequence::Copy);
}

void addViews(QMenu& menu, WindowActions& actions) {
    const std::array<QString, 6> names{Texts::tr("From the &front (A)"), Texts::tr("From the &back (P)"),
                                       Texts::tr("From the &left (L)"),  Texts::tr("From the &right (R)"),
                                       Texts::tr("From the &head (H)"),  Texts::tr("From the f&eet (F)")};
    for (std::size_t i = 0; i < names.size(); ++i)
        actions.views[i] = menu.addAction(names[i], QKeySequence(Qt::Key(Qt::Key_1 + int(i))));
    actions.firstView = menu.addAction(Texts::tr("F&irst view"), QKeySequence(Qt::Key_R));
}

/// How the picture is made and shown.
void addPicture(QMenu& menu, WindowActions& actions) {
    actions.pause = checkable(menu.addAction(Texts::tr("&Pause"), QKeySequence(Qt::Key_Space)));
    actions.pause->setShortcutContext(Qt::WidgetShortcut);  // elsewhere Space presses the button that has the focus
    actions.smoothed = checkable(menu.addAction(Texts::tr("&Smoothed"), QKeySequence(Qt::Key_S)));
    actions.table = checkable(menu.addAction(Texts::tr("&Table and holder"), QKeySequence(Qt::Key_T)));
    actions.captioned =
        checkable(menu.addAction(Texts::tr("&Caption on previews")),
                  Texts::tr("Saved, copied and full-screen pictures say where they are not yet as good as was wanted"));
    actions.errorMap = checkable(menu.addAction(Texts::tr("Where it is still r&ough"), QKeySequence(Qt::Key_E)));
    actions.boxFirst =
        checkable(menu.addAction(Texts::tr("&Box first"), QKeySequence(Qt::Key_B)),
                  Texts::tr("Draw a box on the picture: it gets all samples until it is as good as wanted"));
}

void fillViewMenu(QMenuBar& bar, const QList<QAction*>& panels, WindowActions& actions) {
    QMenu* menu = bar.addMenu(Texts::tr("&View"));
    addViews(*menu, actions);
    menu->addSeparator();
    addPicture(*menu, actions);
    menu->addSeparator();
    menu->addActions(panels);
    actions.alone = checkable(menu->addAction(Texts::tr("Picture &alone"), QKeySequence(Qt::Key_F11)));
}

void fillHelpMenu(QMenuBar& bar, WindowActions& actions) {
    QMenu* menu = bar.addMenu(Texts::tr("&Help"));
    actions.keys = menu->addAction(Texts::tr("&Keys"));
    actions.keys->setShortcuts({QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question)});
    actions.about = menu->addAction(Texts::tr("&About PD-Render"));
}

}  // namespace

WindowActions fillMenus(QMenuBar& bar, const QList<QAction*>& panels) {
    WindowActions actions{};
    fillFileMenu(bar, actions);
    fillEditMenu(bar, actions);
    fillViewMenu(bar, panels, actions);
    fillHelpMenu(bar, actions);
    return actions;
}

}  // namespace pdr::ui
