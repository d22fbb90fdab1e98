#pragma once
/// The desktop program's main window: the image in the middle, the series on the left, look and rendering on the right,
/// accuracy and cost in the status bar. It shows values and emits edits; it knows neither the renderer nor the
/// importer.

#include <QFileInfo>
#include <QMainWindow>
#include <optional>

#include "render/scene/camera.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/effect_ledger.h"
#include "ui/accuracy/foot.h"
#include "ui/camera/camera_panel.h"
#include "ui/cut/cut_tools.h"
#include "ui/keys/key_bindings.h"
#include "ui/keys/keys_overlay.h"
#include "ui/light/light_panel.h"
#include "ui/looks/look_panel.h"
#include "ui/looks/visible_row.h"
#include "ui/nodes/nodes_panel.h"
#include "ui/output/picture_order.h"
#include "ui/rendering/render_panel.h"
#include "ui/series/series_panel.h"
#include "ui/theme/theme.h"
#include "ui/tissue/tissue_panel.h"
#include "ui/view/region_box.h"
#include "ui/view/viewport.h"
#include "ui/window/message_bar.h"
#include "ui/window/start_panel.h"
#include "ui/window/window_actions.h"
#include "ui/window/window_docks.h"

namespace pdr::ui {

/// Returns the folder to open for `path`: the folder that contains it if it is a file, else `path` itself.
QString folderOf(const QFileInfo& path);

class MainWindow : public QMainWindow {
    Q_OBJECT

  public:
    MainWindow();

    Viewport& viewport() { return *viewport_; }
    RegionBox& region() { return *region_; }
    SeriesPanel& series() { return *series_; }
    LookPanel& look() { return *look_; }
    VisibleRow& visible() { return *visible_; }
    TissuePanel& tissue() { return *tissue_; }
    LightPanel& light() { return *light_; }
    CameraPanel& camera() { return *camera_; }
    RenderPanel& rendering() { return *rendering_; }
    EffectLedger& effects() { return *effects_; }
    NodesPanel& nodes() { return *nodes_; }
    Foot& foot() { return *foot_; }
    AccuracyPanel& accuracy() { return *accuracy_; }
    StatusLine& status() { return foot_->status(); }
    MessageBar& message() { return *message_; }
    CutTools& cut() { return *cut_; }

    /// Sets the title bar's description of the open series, and the one shown while names are hidden. Empty: nothing is
    /// open. Neither may contain the patient's name.
    void setSubject(const QString& subject, const QString& whileHidden = {});
    /// Sets whether the user still has to choose a series. While true, the series list stays open even if room is
    /// short.
    void setChoosing(bool choosing) { docks_->setChoosing(choosing); }
    /// Sets the lines that name the patient in the image's upper left corner. Empty: no patient.
    void setPatient(const QStringList& lines);
    /// Returns the patient lines as the corner shows them: the patient's number in their place while names are hidden.
    QStringList patient() const;
    /// Sets the folder in which the dialog for opening a folder begins.
    void setLastFolder(const QString& folder);
    void setUndoAvailable(bool undo, bool redo);
    /// Sets the menu texts of undo and redo, e.g. "Undo turning the view".
    void setUndoTexts(const QString& undo, const QString& redo);
    /// Sets the recently opened folders, newest first. `remembered`: whether the program saves them; if not, the list
    /// is empty.
    void setRecentFolders(const QStringList& folders, bool remembered);
    /// Shows or hides the start panel, which offers ways to open a folder, in the middle of the view.
    void setStartShown(bool shown);
    /// Sets the folder of the example scan. Empty: there is none.
    void setExample(const QString& folder);
    /// Sets whether a volume is open; enables the view, rendering and look controls.
    void setVolumeAvailable(bool available);
    /// Sets the keys that the user has changed, as KeyBindings::choices() returns them.
    void setKeys(const QMap<QString, QString>& choices);
    /// Checks the menu entry of language `code`, one of languages(). Empty: the system's language.
    void setLanguage(const QString& code);
    void setTheme(pdr::ui::ThemeChoice choice);
    void setPaused(bool paused);
    void setSmoothed(bool smoothed);
    /// Sets the box whose pixels get their samples first. None: there is no box.
    void setRegion(const std::optional<QRectF>& box);
    /// Checks and enables the menu entry for the table. `there`: the scan has a table, or other parts hidden with it.
    void setTable(bool shown, bool there);
    /// Sets whether saved and copied images are annotated by default.
    void setCaptioned(bool captioned);
    /// Sets the question to ask before the window closes because work would be lost. Empty: close without asking.
    void setQuestionOnClosing(const QString& question);
    /// Returns the window state to save. It counts panels that are hidden only for lack of room as shown.
    QByteArray wantedState() { return docks_->wantedState(); }
    /// Sets the proposed file name of the current image, and the cost of rendering one like it. None: cost not known
    /// yet.
    void setPictureOffer(const QString& name, const std::optional<PictureCost>& cost);
    /// Sets whether there is an image to save or copy.
    void setPictureAvailable(bool available);

  signals:
    void folderChosen(const QString& folder);
    /// Emitted if other folders than the opened one were dropped as well; they are not opened.
    void othersLeftOut();
    /// Emitted when an OpenEXR file is dropped: an environment image that is to light the volume.
    void skyDropped(const QString& file);
    /// Requests that the image on the screen be saved as it is.
    void saveRequested(const QString& file, pdr::ui::Annotate annotate = pdr::ui::Annotate::sides);
    /// Requests an image rendered anew at a size of its own.
    void pictureOrdered(const pdr::ui::PictureOrder& order);
    /// Requests a copy of the image on the clipboard.
    void copyRequested();
    void keysChosen(const QMap<QString, QString>& choices);
    void rememberFoldersChosen(bool remembered);
    void forgetFoldersRequested();
    void languageChosen(const QString& code);
    void themeChosen(pdr::ui::ThemeChoice choice);
    void undoRequested();
    void redoRequested();
    void viewChosen(pdr::StandardView view);
    void resetRequested();
    /// Requests rendering with as many pixels as the image is shown with.
    void fitRequested();
    void pauseChosen(bool paused);
    void smoothingChosen(bool smoothed);
    void tableChosen(bool shown);
    void captionChosen(bool captioned);
    /// Emitted when the user turns the error map on or off.
    void errorMapChosen(bool shown);
    /// Reports the box whose pixels are to get their samples first, in fractions of the image's width and height. None:
    /// all pixels alike.
    void regionChosen(const std::optional<QRectF>& box);
    /// Requests to cancel reading the scan; emitted on Esc.
    void cancelRequested();
    /// Reports whether the window is minimised or hidden, so that nobody can see it.
    void unseenChanged(bool unseen);
    /// Reports whether the cost table of the effects is visible.
    void effectsShown(bool shown);

  protected:
    void changeEvent(QEvent* event) override;
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void connectFileActions();
    void connectEditActions();
    void connectViewActions();
    void setPicking(Viewport::Picking picking);
    void showMenu(QPoint place);
    void chooseFolder();
    void chooseFile();
    void showPictureAlone(bool alone);
    void chooseRegion(const std::optional<QRectF>& box);
    void drawOrForgetRegion(bool draw);
    void hideName(bool hidden);
    QStringList whatIsSeen() const;
    void editKeys();
    void escape();
    void about();

    Viewport* viewport_;
    RegionBox* region_;
    CutTools* cut_;
    SeriesPanel* series_;
    LookPanel* look_;
    VisibleRow* visible_;
    TissuePanel* tissue_;
    LightPanel* light_;
    CameraPanel* camera_;
    RenderPanel* rendering_;
    EffectLedger* effects_;
    NodesPanel* nodes_;
    Foot* foot_;
    AccuracyPanel* accuracy_;
    MessageBar* message_;
    StartPanel* start_;
    KeysOverlay* keys_;
    WindowDocks* docks_;
    WindowActions actions_;
    KeyBindings bindings_;
    QString lastFolder_;
    QStringList patient_;
    QString subject_, subjectWhileHidden_;
    QString questionOnClosing_;
    QString pictureName_ = "picture";
    QString folderOfPictures_;  ///< where the last image was saved; kept while the program runs
    std::optional<PictureCost> pictureCost_;
};

}  // namespace pdr::ui
