#include "app/document.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "render/scene/fit_view.h"

namespace pdr::app {
namespace {

constexpr double kFilled = 0.92;  ///< share of the picture that the volume takes; the rest is for the letters

}  // namespace

ivec2 filmFor(ivec2 pixels) {
    const int longer = std::max(pixels.x, pixels.y);
    const double scale = longer > kLargestSide ? double(kLargestSide) / longer : 1.0;
    return glm::max(ivec2(glm::round(dvec2(pixels) * scale)), ivec2(1));
}

Document::Document(std::vector<Preset> presets) : presets_(std::move(presets)) {
    assert(!presets_.empty());
}

Display Document::display() const {
    Display display = presets_[std::size_t(now_.preset)].display;
    display.exposure *= float(std::exp2(-now_.brightness));
    return display;
}

void Document::open(std::shared_ptr<const Volume> volume) {
    past_.clear();
    future_.clear();
    handMoves_ = false;
    now_.scene.volume = std::move(volume);
    now_.scene.camera = cameraOf(StandardView::anterior);
    applyPreset();
}

void Document::close() {
    past_.clear();
    future_.clear();
    now_.scene.volume.reset();
}

void Document::setCamera(const Camera& camera, bool moving) {
    if (!hasVolume())
        return;
    if (!handMoves_)
        remember();
    handMoves_ = moving;
    applyCamera(camera, moving);
}

void Document::setView(StandardView view) {
    setCamera(hasVolume() ? cameraOf(view) : Camera{}, false);
}

void Document::setPreset(int index) {
    if (index < 0 || index >= int(presets_.size()))
        return;
    if (hasVolume())
        remember();
    now_.preset = index;
    now_.brightness = 0;
    applyPreset();
}

void Document::setEstimator(Estimator estimator) {
    if (estimator == now_.scene.estimator)
        return;
    State state = now_;
    state.scene.estimator = estimator;
    if (!hasVolume()) {
        now_ = std::move(state);
        return;
    }
    remember();
    apply(std::move(state), false);
}

void Document::setBrightness(double stops) {
    now_.brightness = stops;
    emit displayChanged(display());
}

void Document::setViewSize(ivec2 pixels) {
    now_.scene.film = filmFor(pixels);
    if (hasVolume())
        apply(now_, false);
}

void Document::undo() {
    if (!canUndo())
        return;
    future_.push_back(now_);
    State state = std::move(past_.back());
    past_.pop_back();
    handMoves_ = false;
    apply(std::move(state), false);
    emit displayChanged(display());
}

void Document::redo() {
    if (!canRedo())
        return;
    past_.push_back(now_);
    State state = std::move(future_.back());
    future_.pop_back();
    handMoves_ = false;
    apply(std::move(state), false);
    emit displayChanged(display());
}

void Document::remember() {
    past_.push_back(now_);
    future_.clear();
}

/// The window's size and the revision are not undone: an earlier state comes back as a new value.
void Document::apply(State state, bool moving) {
    const ivec2 film = now_.scene.film;
    now_ = std::move(state);
    now_.scene.film = film;
    now_.scene.revision = ++revision_;
    emit sceneChanged(now_.scene, moving);
}

/// Without a volume the choice waits for one.
void Document::applyPreset() {
    emit displayChanged(display());
    if (!hasVolume())
        return;
    State state = now_;
    state.scene = withPreset(std::move(state.scene), presets_[std::size_t(state.preset)]);
    apply(std::move(state), false);
}

/// The lights hang on the camera, so they are made anew with it.
void Document::applyCamera(const Camera& camera, bool moving) {
    State state = now_;
    state.scene.camera = camera;
    state.scene.lights = lightRig(presets_[std::size_t(state.preset)], state.scene.volume->geometry(), camera);
    apply(std::move(state), moving);
}

Camera Document::cameraOf(StandardView view) const {
    const VolumeGeometry& geometry = now_.scene.volume->geometry();
    const double aspect = double(now_.scene.film.x) / now_.scene.film.y;
    return fittedView(standardView(view, geometry.centreMm(), geometry.radiusMm(), aspect), geometry, aspect, kFilled);
}

}  // namespace pdr::app
