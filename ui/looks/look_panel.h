#pragma once
/// The panel for the volume's appearance: the gallery of looks, what the current one does not show, brightness, and
/// whether rendering is paused. Setters emit no signals.

#include <QCheckBox>
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
    /// Marks the current look. -1: none of the looks is shown.
    void setLook(int index);
    /// Sets the sentences on what the look does not show. Empty: nothing is known about it.
    void setDoesNotShow(const QString& sentence);
    /// Sets the brightness in stops, clamped to [-4, 4]: one more is twice as bright, 0 is as the look defines it.
    void setBrightness(double stops);
    /// Sets whether the CT is shown with less noise, and whether that can be chosen.
    void setCtDenoised(bool denoised, bool offered);
    void setPaused(bool paused);

    QSize sizeHint() const override { return {230, 400}; }

  signals:
    void lookChosen(int index);
    /// Reports the chosen brightness [stops]. `moving`: the slider is still held down; the last report of a gesture
    /// comes with false.
    void brightnessChosen(double stops, bool moving);
    void ctDenoisedChosen(bool denoised);
    void pauseChosen(bool paused);

  private:
    QScrollArea scroll_;  ///< around the gallery; declared before it, so destroyed after it
    LookGallery gallery_;
    QLabel doesNotShow_;
    QSlider brightness_;
    QCheckBox ctDenoised_;
    LookMenu menu_;
    QPushButton pause_;
};

}  // namespace pdr::ui
