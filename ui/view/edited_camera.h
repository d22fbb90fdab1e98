#pragma once
/// The camera that gestures, the wheel and keys edit. The setter emits no signal.

#include <QObject>
#include <QTimer>
#include <optional>

#include "render/scene/camera.h"

namespace pdr::ui {

class EditedCamera : public QObject {
    Q_OBJECT

  public:
    EditedCamera();

    /// Sets the camera that the next edit starts from. None: there is nothing to edit.
    void set(const std::optional<Camera>& camera);
    const std::optional<Camera>& get() const { return camera_; }
    /// Edits the camera as part of a gesture.
    void edit(const Camera& camera);
    /// Edits the camera in a step of wheel or key. As these have no release, a rest after the last step ends them.
    void step(const Camera& camera);
    /// Handles that a gesture begins: the edits have no end before letGo().
    void hold() { held_ = true; }
    void letGo();

  signals:
    /// Reports an edit. `moving`: more follow; the last report comes with false.
    void edited(const pdr::Camera& camera, bool moving);

  private:
    void rest();

    std::optional<Camera> camera_;
    bool held_ = false;
    bool moved_ = false;  ///< edits have been reported, but not their end
    QTimer restTimer_;
};

}  // namespace pdr::ui
