#pragma once
/// The desktop program's main window: the image in the middle, panels around it, menus, a message bar over the image,
/// and the status bar. It knows what belongs to no single feature; the panels join it from outside. It knows neither
/// the renderer nor the importer.

#include <QFileInfo>
#include <QMainWindow>
#include <functional>
#include <optional>
#include <vector>

#include "ui/accuracy/accuracy_status.h"
#include "ui/keys/key_bindings.h"
#include "ui/keys/keys_overlay.h"
#include "ui/theme/theme.h"
#include "ui/view/viewport.h"
#include "ui/window/message_bar.h"
#include "ui/window/start_panel.h"
#include "ui/window/view_grid.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_docks.h"

namespace pdr::ui {

/// Returns the place to open for `path`: the folder that contains it if it is one file of a scan among others; `path`
/// itself if it is a folder or holds a whole scan (kScanEndings).
QString folderOf(const QFileInfo& path);

class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow();

    Viewport& viewport() { return *viewport_; }
    /// The views in the middle of the window: the viewport, and those that are added.
    ViewGrid& views() { return *views_; }
    /// Adds the view of a slice, which the window then owns. Esc cancels what its `tools` are doing, too.
    void addSlice(QWidget* view, ViewTools& tools);
    AccuracyStatus& accuracyStatus() { return *accuracyStatus_; }
    StatusLine& status() { return accuracyStatus_->status(); }
    MessageBar& message() { return *message_; }
    /// The panel in place of the image while nothing is open.
    StartPanel& start() { return *start_; }
    /// The actions of the menus.
    const WindowActions& menuActions() const { return actions_; }

    /// Adds a panel, which the window then owns, and its entry in the View menu. Returns the action that opens and
    /// closes it.
    QAction* addPanel(QWidget* panel, const PanelInfo& info);
    /// Returns the action that opens and closes the panel `name`; null if there is none.
    QAction* panelToggle(const QString& name) const { return docks_->toggle(name); }
    /// Fills the tool bar with actions of the menus; called when all are there.
    void fillToolBar();
    /// Adds a menu to the left of Help; `fill` fills it.
    void addMenu(const QString& title, const std::function<void(QMenu&)>& fill);

    /// Sets the title bar's description of the open series, and the one shown while names are hidden. Empty: nothing is
    /// open. Neither may contain the patient's name.
    void setSubject(const QString& subject, const QString& whileHidden = {});
    /// Sets whether the user still has to choose a series. While true, the series list stays open even if room is
    /// short.
    void setChoosing(bool choosing) { docks_->setChoosing(choosing); }
    /// Sets the lines that name the patient in the image's upper left corner, and the ones shown while names are
    /// hidden. Empty: no patient.
    void setPatient(const QStringList& lines, const QStringList& whileHidden = {});
    /// Returns the patient lines as the corner shows them.
    QStringList patient() const { return namesHidden() ? patientWhileHidden_ : patient_; }
    /// Whether the user has hidden the names of patients.
    bool namesHidden() const { return actions_.hideName->isChecked(); }
    /// Sets the folder in which the dialog for opening a folder begins.
    void setLastFolder(const QString& folder);
    /// Sets the recently opened folders, newest first. `remembered`: whether the program saves them; if not, the list
    /// is empty.
    void setRecentFolders(const QStringList& folders, bool remembered);
    /// Sets the keys that the user has changed, as KeyBindings::choices() returns them.
    void setKeys(const QMap<QString, QString>& choices);
    /// Checks the menu entry of language `code`, one of languages(). Empty: the system's language.
    void setLanguage(const QString& code);
    void setTheme(pdr::ui::ThemeChoice choice);
    /// Sets the question to ask before the window closes because work would be lost. Empty: close without asking.
    void setQuestionOnClosing(const QString& question);
    /// Sets the question to ask before work on the open series is lost: because the window closes, or another series is
    /// opened. Empty: nothing would be lost.
    void setUnsaved(const QString& question) { unsaved_ = question; }
    /// Asks that question, if there is one. Returns whether the work may be lost.
    bool confirmsLoss();
    /// Returns the window state to save. It counts panels that are hidden only for lack of room as shown.
    QByteArray wantedState() { return docks_->wantedState(); }
    /// Restores what wantedState() returned at an earlier run. The state of another version changes nothing.
    void restorePanels(const QByteArray& state) { docks_->restore(state); }

  signals:
    void folderChosen(const QString& folder);
    /// Emitted if other folders than the opened one were dropped as well; they are not opened.
    void othersLeftOut();
    /// Emitted when the context menu of the image is about to open, so that features can add entries about `place`, in
    /// fractions of the image's width and height. Only emitted for a place of an image.
    void imageMenuOpens(QMenu* menu, QPointF place);
    /// Emitted when an OpenEXR file is dropped: an environment image that is to light the volume.
    void skyDropped(const QString& file);
    /// Emitted when a plan file is dropped.
    void planDropped(const QString& file);
    void keysChosen(const QMap<QString, QString>& choices);
    void languageChosen(const QString& code);
    void themeChosen(pdr::ui::ThemeChoice choice);
    /// Reports whether the names of patients are hidden from now on.
    void namesHiddenChanged(bool hidden);
    /// Requests to end whatever waits or runs: emitted on Esc, unless Esc has cancelled what a tool of the view was
    /// doing.
    void cancelRequested();
    /// Reports whether the window is minimised or hidden, so that nobody can see it.
    void unseenChanged(bool unseen);

  protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void connectActions();
    void connectView();
    KeyBindings& bindings();
    void showMenu(QPoint place);
    void chooseFolder();
    void chooseFile();
    void showImageAlone(bool alone);
    void hideNames(bool hidden);
    QStringList linesOverImage() const;
    void editKeys();
    void escape();
    void about();

    Viewport* viewport_;
    ViewGrid* views_;
    std::vector<ViewTools*> tools_;  ///< those of the viewport first, then of each slice view
    AccuracyStatus* accuracyStatus_;
    MessageBar* message_;
    StartPanel* start_;
    KeysOverlay* keys_;
    WindowDocks* docks_;
    WindowActions actions_;
    std::optional<KeyBindings> bindings_;  ///< made when all actions are in the menus; see bindings()
    QString lastFolder_;
    QStringList patient_, patientWhileHidden_;
    QString subject_, subjectWhileHidden_;
    QString questionOnClosing_, unsaved_;
};

}  // namespace pdr::ui
