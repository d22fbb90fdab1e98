#include "ui/window/window_actions.h"

#include <QCoreApplication>
#include <QMenu>

#include "ui/text/language.h"

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
    actions.openFile = menu->addAction(Texts::tr("Open f&ile..."));
    actions.recent = new RecentMenu(&bar);
    menu->addMenu(actions.recent);
    actions.save = menu->addAction(Texts::tr("&Save image..."), QKeySequence::Save);
    menu->addSeparator();
    actions.openPlan = menu->addAction(Texts::tr("Open &plan..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O));
    actions.savePlan = menu->addAction(Texts::tr("Sa&ve plan..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S));
    actions.exportMarks = menu->addAction(Texts::tr("E&xport measurements..."));
    menu->addSeparator();
    actions.quit = menu->addAction(Texts::tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q));
}

void fillEditMenu(QMenuBar& bar, WindowActions& actions) {
    QMenu* menu = bar.addMenu(Texts::tr("&Edit"));
    actions.undo = menu->addAction(Texts::tr("&Undo"), QKeySequence::Undo);
    actions.redo = menu->addAction(Texts::tr("&Redo"));
    actions.redo->setShortcuts({QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z), QKeySequence(Qt::CTRL | Qt::Key_Y)});
    menu->addSeparator();
    actions.copy = menu->addAction(Texts::tr("&Copy image"), QKeySequence::Copy);
}

void addViews(QMenu& menu, WindowActions& actions) {
    const std::array<QString, 6> names{Texts::tr("From the &front (A)"), Texts::tr("From the &back (P)"),
                                       Texts::tr("From the &left (L)"),  Texts::tr("From the &right (R)"),
                                       Texts::tr("From the &head (H)"),  Texts::tr("From the f&eet (F)")};
    for (std::size_t i = 0; i < names.size(); ++i)
        actions.views[i] = menu.addAction(names[i], QKeySequence(Qt::Key(Qt::Key_1 + int(i))));
    actions.firstView = menu.addAction(Texts::tr("R&eset view"), QKeySequence(Qt::Key_R));
    actions.fit = menu.addAction(Texts::tr("Render at the window's si&ze"));
}

/// Adds the actions for how the image is rendered and shown.
void addImage(QMenu& menu, WindowActions& actions) {
    actions.pause = checkable(menu.addAction(Texts::tr("&Pause"), QKeySequence(Qt::Key_Space)));
    actions.pause->setShortcutContext(Qt::WidgetShortcut);  // elsewhere Space presses the button that has the focus
    actions.denoised = checkable(menu.addAction(Texts::tr("&Denoised"), QKeySequence(Qt::Key_S)));
    actions.table = checkable(menu.addAction(Texts::tr("&Table and holder"), QKeySequence(Qt::Key_T)));
    actions.captioned = checkable(
        menu.addAction(Texts::tr("A&nnotate saved images")),
        Texts::tr("Saved and copied images say which side is which, what they show, and that they are not for "
                  "diagnostic use."));
    actions.captioned->setChecked(true);
    actions.errorMap = checkable(menu.addAction(Texts::tr("E&rror map"), QKeySequence(Qt::Key_E)));
    actions.boxFirst =
        checkable(menu.addAction(Texts::tr("Refine a &region"), QKeySequence(Qt::Key_B)),
                  Texts::tr("Draw a box on the image: it gets all samples until it reaches the target."));
}

void addThemes(QMenu& view, WindowActions& actions) {
    QMenu* menu = view.addMenu(Texts::tr("&Theme"));
    auto* one = new QActionGroup(menu);
    const std::array<QString, 3> names{Texts::tr("&Dark"), Texts::tr("&Light"), Texts::tr("As the &system")};
    for (std::size_t i = 0; i < names.size(); ++i)
        actions.themes[i] = one->addAction(checkable(menu->addAction(names[i])));
}

void addLanguages(QMenu& view, WindowActions& actions) {
    QMenu* menu = view.addMenu(Texts::tr("Lan&guage"));
    actions.languages = new QActionGroup(menu);
    const auto add = [&](const QString& name, const QString& code) {
        actions.languages->addAction(checkable(menu->addAction(name)))->setData(code);
    };
    add(Texts::tr("As the &system"), {});
    for (const QString& code : languages())
        add(languageName(code), code);
}

void fillViewMenu(QMenuBar& bar, WindowActions& actions) {
    QMenu* menu = actions.view = bar.addMenu(Texts::tr("&View"));
    addViews(*menu, actions);
    menu->addSeparator();
    addImage(*menu, actions);
    menu->addSeparator();
    actions.endOfPanels = menu->addSeparator();
    addThemes(*menu, actions);
    addLanguages(*menu, actions);
    actions.hideName = checkable(menu->addAction(Texts::tr("Hide the patient's &name"), QKeySequence(Qt::Key_N)),
                                 Texts::tr("For screenshots: no patient is named anywhere in the window."));
    actions.alone = checkable(menu->addAction(Texts::tr("&Full screen"), QKeySequence(Qt::Key_F11)));
}

void fillHelpMenu(QMenuBar& bar, WindowActions& actions) {
    QMenu* menu = bar.addMenu(Texts::tr("&Help"));
    actions.manual = menu->addAction(Texts::tr("&Manual"), QKeySequence(Qt::Key_F1));
    actions.keys = menu->addAction(Texts::tr("&Keys"));
    actions.keys->setShortcuts({QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question)});
    actions.editKeys = menu->addAction(Texts::tr("&Edit keys..."));
    actions.about = menu->addAction(Texts::tr("&About PD-Render"));
}

struct Sentence {
    QAction* action;
    const char* name;
    QString toolTip;
};

void describe(const WindowActions& actions) {
    const std::array<const char*, 6> sides{"anterior", "posterior", "left", "right", "superior", "inferior"};
    for (std::size_t i = 0; i < sides.size(); ++i) {
        actions.views[i]->setObjectName(sides[i]);
        actions.views[i]->setToolTip(Texts::tr("Shows the patient from this side, filling the view."));
    }
    for (const auto& [action, name, toolTip] : std::initializer_list<Sentence>{
             {actions.open, "open", Texts::tr("Opens a folder of DICOM files.")},
             {actions.openFile, "openFile",
              Texts::tr("Opens a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage.")},
             {actions.save, "save", Texts::tr("Saves the image as PNG or EXR, as shown or rendered at any size.")},
             {actions.openPlan, "openPlan", Texts::tr("Opens what was set and measured on this scan before.")},
             {actions.savePlan, "savePlan",
              Texts::tr("Saves what is set and measured, without the patient's name, for this scan alone.")},
             {actions.exportMarks, "exportMarks",
              Texts::tr("Writes the measurements for spreadsheets (CSV) or 3D Slicer, without the patient's name.")},
             {actions.quit, "quit", Texts::tr("Closes the window. Unsaved images are lost.")},
             {actions.undo, "undo", {}},
             {actions.redo, "redo", {}},
             {actions.copy, "copy",
              Texts::tr("Copies the image to the clipboard, with its caption and without the patient's name.")},
             {actions.firstView, "firstView", Texts::tr("Returns to the view in which the series was opened.")},
             {actions.fit, "fitImage",
              Texts::tr("Renders the image again at the size at which it is shown; the next edit does so as well.")},
             {actions.pause, "pause", Texts::tr("Pauses rendering, or continues it, also beyond the target.")},
             {actions.denoised, "denoised", Texts::tr("Shows the denoised or the raw image.")},
             {actions.table, "table",
              Texts::tr("Shows or hides what is solid, outside the body and thinner than 20 mm.")},
             {actions.captioned, "caption", {}},
             {actions.errorMap, "errorMap", Texts::tr("Colours each pixel by its 95 % error, in grey levels of 255.")},
             {actions.boxFirst, "box", {}},
             {actions.hideName, "hideName", {}},
             {actions.alone, "alone",
              Texts::tr("Fills the screen with the image, the patient's name and its accuracy.")},
             {actions.manual, "manual", Texts::tr("Opens the manual, which needs no network.")},
             {actions.keys, "keys", Texts::tr("Shows all keys and what they do.")},
             {actions.editKeys, "editKeys", Texts::tr("Changes keyboard shortcuts.")},
             {actions.about, "about",
              Texts::tr("Shows the version, the licence, and what this program is not for.")}}) {
        action->setObjectName(name);
        if (!toolTip.isEmpty())
            action->setToolTip(toolTip);
    }
}

}  // namespace

WindowActions fillMenus(QMenuBar& bar) {
    WindowActions actions{};
    fillFileMenu(bar, actions);
    fillEditMenu(bar, actions);
    fillViewMenu(bar, actions);
    fillHelpMenu(bar, actions);
    describe(actions);
    for (const QAction* menu : bar.actions())
        menu->menu()->setToolTipsVisible(true);
    return actions;
}

}  // namespace pdr::ui
