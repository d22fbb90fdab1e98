#pragma once
/// How the volume looks: presets and brightness; and whether the rendering holds. Setters are silent.

#include <QButtonGroup>
#include <QPushButton>
#include <QSlider>
#include <QVBoxLayout>
#include <QWidget>

namespace pdr::ui {

class LookPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LookPanel(QWidget* parent = nullptr);

    void setPresets(const QStringList& names);
    /// -1: none of them is shown.
    void setPreset(int index);
    /// In stops: one more is twice as bright; 0 = as the preset says. Kept in [-4, 4].
    void setBrightness(double stops);
    void setPaused(bool paused);

    QSize sizeHint() const override { return {220, 400}; }

  signals:
    void presetChosen(int index);
    /// `moving`: the slider is still held; the last one of a gesture comes with false.
    void brightnessChosen(double stops, bool moving);
    void pauseChosen(bool paused);
    /// The curves and colours behind the presets are to be edited, or not any more.
    void tissueWanted();
    /// The same of the lights.
    void lightWanted();

  private:
    QVBoxLayout* presetColumn_;
    QButtonGroup presets_;
    QSlider brightness_;
    QPushButton tissue_;
    QPushButton light_;
    QPushButton pause_;
};

}  // namespace pdr::ui
