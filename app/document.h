#pragma once
/// What is shown and how: a Scene with its preset and display, and the way back to earlier ones. The one place where a
/// scene's revision grows.

#include <QObject>
#include <deque>
#include <memory>
#include <vector>

#include "render/film/display.h"
#include "render/scene/preset.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// The film for a view of `pixels`: as large, but its longer side at most kLargestSide pixels, so that a processor
/// without a GPU still shows a picture at once; the view stretches it. At least 1 x 1.
ivec2 filmFor(ivec2 pixels);
inline constexpr int kLargestSide = 1024;

class Document : public QObject {
    Q_OBJECT

  public:
    /// `presets` holds at least one.
    explicit Document(std::vector<Preset> presets);

    const std::vector<Preset>& presets() const { return presets_; }
    const Scene& scene() const { return now_.scene; }
    bool hasVolume() const { return now_.scene.volume != nullptr; }
    int preset() const { return now_.preset; }
    /// Brightness in stops against the preset's; one more is twice as bright.
    double brightness() const { return now_.brightness; }
    Display display() const;
    bool canUndo() const { return !past_.empty(); }
    bool canRedo() const { return !future_.empty(); }

  public slots:
    /// Shows `volume` from the front, with the preset as it is. There is no way back to the volume before.
    void open(std::shared_ptr<const pdr::Volume> volume);
    /// Shows nothing.
    void close();
    /// One gesture of the user (moving, ..., moving, at rest) is one step to undo. One that ends where it began makes no
    /// other scene.
    void setCamera(const pdr::Camera& camera, bool moving);
    void setView(pdr::StandardView view);
    void setPreset(int index);
    void setEstimator(pdr::Estimator estimator);
    /// Only what is shown changes, not what is computed. A step to undo of its own, one for each gesture as well.
    void setBrightness(double stops, bool moving = false);
    /// The view's size in pixels; no step to undo. The picture begins anew where its film has another size.
    void setViewSize(pdr::ivec2 pixels);
    void undo();
    void redo();

  signals:
    /// There is another scene to render. `moving`: more will follow at once.
    void sceneChanged(const pdr::Scene& scene, bool moving);
    void displayChanged(const pdr::Display& display);

  private:
    /// All that undo brings back.
    struct State {
        Scene scene;
        int preset = 0;
        double brightness = 0;
        std::uint64_t edit = 0;  ///< number of the edit that made the scene; the same number: the same scene
    };
    /// The gesture in progress.
    enum class Gesture { none, camera, brightness };
    /// Steps that can be undone: more than anyone goes back, and little memory.
    static constexpr std::size_t kSteps = 300;

    void remember(Gesture gesture = Gesture::none, bool moving = false);
    void edit(State state, bool moving);
    void show(State state, bool moving);
    void comeBackTo(State state);
    void rest();
    void applyPreset();
    void applyCamera(const Camera& camera, bool moving);
    Camera cameraOf(StandardView view) const;

    std::vector<Preset> presets_;
    State now_;
    std::deque<State> past_;
    std::vector<State> future_;
    Gesture gesture_ = Gesture::none;
    std::uint64_t revision_ = 0;
    std::uint64_t edits_ = 0;
};

}  // namespace pdr::app
