#pragma once
/// The desktop's window: the picture in the middle, the series on the left, the look and the rendering on the right,
/// the truth about it at the foot. It shows values and emits edits; it knows no renderer and no importer.

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

/// What is opened of `path`: the folder that a file lies in, or it itself.
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

    /// What is shown, for the title bar, and what stands there while names are hidden; empty for nothing. Never the
    /// patient's name.
    void setSubject(const QString& subject, const QString& whileHidden = {});
    /// A series is to be chosen: their list stays open, whatever it takes.
    void setChoosing(bool choosing) { docks_->setChoosing(choosing); }
    /// Whose series is shown, a line each, for the picture's upper left corner; empty: nobody's.
    void setPatient(const QStringList& lines);
    /// What that corner says: a number in the place of all that while names are hidden.
    QStringList patient() const;
    /// Where the dialogs for opening and saving begin.
    void setLastFolder(const QString& folder);
    void setUndoAvailable(bool undo, bool redo);
    /// What the next steps back and forth are called: "Undo turning the view".
    void setUndoTexts(const QString& undo, const QString& redo);
    /// The newest first; none where they are not remembered.
    void setRecentFolders(const QStringList& folders, bool remembered);
    /// Ways to open something, in the place of the picture.
    void setStartShown(bool shown);
    /// A folder to try with; empty: there is none.
    void setExample(const QString& folder);
    /// Whether there is something that views, looks and the like act on.
    void setVolumeAvailable(bool available);
    /// Which actions have other keys than their own: KeyBindings::choices().
    void setKeys(const QMap<QString, QString>& choices);
    /// Of languages(), or empty for the system's.
    void setLanguage(const QString& code);
    void setTheme(pdr::ui::ThemeChoice choice);
    void setPaused(bool paused);
    void setSmoothed(bool smoothed);
    /// The box on the picture that gets its samples first; none: there is none.
    void setRegion(const std::optional<QRectF>& box);
    /// `there`: there is a table, or what else is hidden with it, to show or hide.
    void setTable(bool shown, bool there);
    /// Whether pictures that leave the window are annotated, unless it is said otherwise.
    void setCaptioned(bool captioned);
    /// What is asked before the window closes, since something would be lost; empty: nothing would.
    void setQuestionOnClosing(const QString& question);
    /// For another time: panels that fold because the window is small are there.
    QByteArray wantedState() { return docks_->wantedState(); }
    /// What the picture on the screen may be called in a file, and what one like it costs; none: not known yet.
    void setPictureOffer(const QString& name, const std::optional<PictureCost>& cost);
    /// Whether there is a picture to save or copy.
    void setPictureAvailable(bool available);

  signals:
    void folderChosen(const QString& folder);
    /// More was dropped than folderChosen() told.
    void othersLeftOut();
    /// A picture of surroundings that is to light the volume.
    void skyDropped(const QString& file);
    /// What is on the screen, as it is.
    void saveRequested(const QString& file, pdr::ui::Annotate annotate = pdr::ui::Annotate::sides);
    /// A picture of a size of its own.
    void pictureOrdered(const pdr::ui::PictureOrder& order);
    /// The picture is wanted on the clipboard.
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
    /// The image is to be rendered at the size at which it is shown.
    void fitRequested();
    void pauseChosen(bool paused);
    void smoothingChosen(bool smoothed);
    void tableChosen(bool shown);
    void captionChosen(bool captioned);
    /// Whether the picture is to show where it is still rough.
    void errorMapChosen(bool shown);
    /// Which box of the picture is to get its samples first, in fractions of its width and height; none: all alike.
    void regionChosen(const std::optional<QRectF>& box);
    /// By Esc: reading is to end.
    void cancelRequested();
    /// Nobody can see the window, minimised or hidden; or it is back.
    void unseenChanged(bool unseen);
    /// What the effects cost is looked at, or not any more.
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
    QString folderOfPictures_;  ///< of the last one saved, as long as the program runs
    std::optional<PictureCost> pictureCost_;
};

}  // namespace pdr::ui
