#include "app/presenters/preferences_presenter.h"

#include <QApplication>

namespace pdr::app {

PreferencesPresenter::PreferencesPresenter(const Workspace& workspace) : Presenter(workspace) {
    window().setLanguage(settings().language());
    window().setTheme(settings().theme());
    window().setKeys(settings().keys());
    connect(&window(), &ui::MainWindow::keysChosen, this,
            [this](const QMap<QString, QString>& keys) { settings().keepKeys(keys); });
    connect(&window(), &ui::MainWindow::languageChosen, this, [this](const QString& code) {
        settings().keepLanguage(code);
        window().status().showForAWhile(ui::MainWindow::tr("The language changes after a restart"));
    });
    connect(&window(), &ui::MainWindow::themeChosen, this, [this](ui::ThemeChoice choice) {
        settings().keepTheme(choice);
        ui::applyTheme(*qApp, choice);
    });
}

}  // namespace pdr::app
