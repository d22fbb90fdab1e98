#pragma once
/// The panel for the camera: viewpoint, lens and background. Setters emit no signals.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <optional>

#include "render/scene/camera.h"

namespace pdr::ui {

class CameraPanel : public QWidget {
    Q_OBJECT

  public:
    explicit CameraPanel(QWidget* parent = nullptr);

    void setCamera(const Camera& camera);
    /// Sets the background as a screen colour. None: the environment.
    void setBackground(const std::optional<QColor>& colour);
    /// Sets whether the next click on the image chooses what is in focus.
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
    QPushButton noFocus_;
    QLabel sharp_;
    QComboBox behind_;
};

}  // namespace pdr::ui
