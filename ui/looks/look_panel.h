#pragma once
/// How the volume looks: the gallery of looks, what the chosen one does not show, and brightness; and whether the
/// rendering holds. Setters are silent.

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QWidget>

#include "ui/looks/look_gallery.h"
#include "ui/looks/look_menu.h"

namespace pdr::ui {

class LookPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LookPanel(QWidget* parent = nullptr);

    LookGallery& gallery() { return gallery_; }
    LookMenu& menu() { return menu_; }
    /// -1: none of them is shown.
    void setLook(int index);
    /// What is not seen, in sentences; empty: nothing is known of it.
    void setDoesNotShow(const QString& sentence);
    /// In stops: one more is twice as bright; 0 = as the look says. Kept in [-4, 4].
    void setBrightness(double stops);
    void setPaused(bool paused);

    QSize sizeHint() const override { return {230, 400}; }

  signals:
    void lookChosen(int index);
    /// `moving`: the slider is still held; the last one of a gesture comes with false.
    void brightnessChosen(double stops, bool moving);
    void pauseChosen(bool paused);
    /// The curves and colours behind the looks are to be edited, or not any more.
    void tissueWanted();
    /// The same of the lights.
    void lightWanted();
    /// The same of the camera.
    void cameraWanted();

  private:
    QScrollArea scroll_;  ///< around the gallery, which leaves it first
    LookGallery gallery_;
    QLabel doesNotShow_;
    QSlider brightness_;
    LookMenu menu_;
    QPushButton tissue_;
    QPushButton light_;
    QPushButton camera_;
    QPushButton pause_;
};

}  // namespace pdr::ui
