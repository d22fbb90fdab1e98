#pragma once
/// The panel that shows and edits the lights: a named rig or an environment image, the lamps on a ball, the chosen
/// lamp's strength and size, light from all around, what the lamps turn with, and the light transport model; collapsed
/// at first, all numbers. Setters emit no signals.

#include <QButtonGroup>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSlider>
#include <QToolButton>
#include <QWidget>

#include "render/scene/camera.h"
#include "render/scene/lamp.h"
#include "render/scene/named_rig.h"
#include "ui/light/light_sphere.h"
#include "ui/light/model_choice.h"
#include "ui/light/panel_table.h"
#include "ui/light/sky_row.h"

namespace pdr::ui {

class LightPanel : public QWidget {
    Q_OBJECT

  public:
    explicit LightPanel(QWidget* parent = nullptr);

    /// Sets the lighting and the camera of the view. A lighting that differs from the user's last edit ends the
    /// gesture.
    void setLighting(const Lighting& lighting, const Camera& camera);

    const Lighting& lighting() const { return lighting_; }
    LightSphere& sphere() { return sphere_; }
    PanelTable& table() { return table_; }
    ModelChoice& model() { return model_; }

    QSize sizeHint() const override { return {316, QWidget::sizeHint().height()}; }

  signals:
    /// Reports an edited lighting. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void lightingEdited(const pdr::Lighting& lighting, bool moving);
    /// Requests the environment image in `file`, which replaces the rig.
    void skyChosen(const QString& file);

  private:
    void describeControls();
    void layOut();
    void connectParts();
    QWidget* rigButtons();
    void showLighting();
    void showLamp();
    void apply(const Lighting& lighting, bool moving);
    void chooseRig(NamedRig name);
    void moveLamp(int index, dvec3 from, bool moving);
    void turnAll(dvec2 drag, bool moving);
    void slideStrength();
    void slideSize();
    void slideAmbient();
    void tie(int index);
    const Lamp* lamp() const;

    Lighting lighting_;
    Camera camera_;
    std::vector<Lamp> lamps_;  ///< lamps of the rig, in the sphere's order
    QButtonGroup rigs_;
    SkyRow sky_;
    LightSphere sphere_;
    QLabel place_;
    QSlider strength_{Qt::Horizontal};
    QSlider size_{Qt::Horizontal};
    QSlider ambient_{Qt::Horizontal};
    QComboBox follows_;
    ModelChoice model_;
    QToolButton expert_;
    PanelTable table_;
};

}  // namespace pdr::ui
