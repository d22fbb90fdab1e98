#pragma once
/// From where and through which lens the volume is seen, and what stands behind it. Setters are silent.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QWidget>
#include <optional>

#include "render/scene/camera.h"

namespace pdr::ui {

class CameraPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CameraPanel(QWidget* parent = nullptr);

    void setCamera(const Camera& camera);
    /// What stands behind the volume, as the screen shows it; none: the light from all around.
    void setBackground(const std::optional<QColor>& colour);
    /// Whether the next click on the picture says what is to be sharp.
    void setPicking(bool picking);

    QSize sizeHint() const override { return {316, QWidget::sizeHint().height()}; }

  signals:
    void cameraEdited(const pdr::Camera& camera);
    void viewChosen(pdr::StandardView view);
    void backgroundChosen(const std::optional<QColor>& colour);
    void pickingChosen(bool picking);

  private:
    void describeControls();
    void layOut();
    void connectParts();
    QWidget* views();
    void showCamera();
    void chooseBackground(int index);
    void askForColour();
    void apply(const Camera& camera);

    Camera camera_;
    std::optional<QColor> background_ = QColor(Qt::black);
    QComboBox type_;
    QDoubleSpinBox fieldOfView_;
    QDoubleSpinBox height_;
    QDoubleSpinBox aperture_;
    QPushButton focus_;
    QToolButton noFocus_;
    QLabel sharp_;
    QComboBox behind_;
};

}  // namespace pdr::ui
