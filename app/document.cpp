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
    gesture_ = Gesture::none;
    now_.scene.volume = std::move(volume);
    now_.scene.camera = cameraOf(StandardView::anterior);
    applyPreset();
}

void Document::close() {
    past_.clear();
    future_.clear();
    gesture_ = Gesture::none;
    now_.scene.volume.reset();
}

void Document::setCamera(const Camera& camera, bool moving) {
    if (!hasVolume())
        return;
    if (camera == now_.scene.camera && !moving)
        return rest();
    remember(Gesture::camera, moving);
    applyCamera(camera, moving);
}

/// Where the user is pointing: no other scene. Where it was not at the camera there is nothing new at all.
void Document::rest() {
    if (std::exchange(gesture_, Gesture::none) == Gesture::camera)
        emit sceneChanged(now_.scene, false);
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
    edit(std::move(state), false);
}

void Document::setBrightness(double stops, bool moving) {
    if (stops == now_.brightness && gesture_ != Gesture::brightness)
        return;
    if (hasVolume())
        remember(Gesture::brightness, moving);
    now_.brightness = stops;
    emit displayChanged(display());
}

void Document::setViewSize(ivec2 pixels) {
    const ivec2 film = filmFor(pixels);
    if (film == now_.scene.film)
        return;
    now_.scene.film = film;
    if (hasVolume())
        show(now_, false);
}

void Document::undo() {
    if (!canUndo())
        return;
    future_.push_back(now_);
    State state = std::move(past_.back());
    past_.pop_back();
    comeBackTo(std::move(state));
}

void Document::redo() {
    if (!canRedo())
        return;
    past_.push_back(now_);
    State state = std::move(future_.back());
    future_.pop_back();
    comeBackTo(std::move(state));
}

/// What stands now becomes a step to undo, unless `gesture` goes on.
void Document::remember(Gesture gesture, bool moving) {
    const bool continues = gesture != Gesture::none && gesture == gesture_;
    gesture_ = moving ? gesture : Gesture::none;
    if (continues)
        return;
    past_.push_back(now_);
    if (past_.size() > kSteps)
        past_.pop_front();
    future_.clear();
}

void Document::edit(State state, bool moving) {
    state.edit = ++edits_;
    show(std::move(state), moving);
}

/// The window's size and the revision are not undone: an earlier state comes back as a new value.
void Document::show(State state, bool moving) {
    const ivec2 film = now_.scene.film;
    now_ = std::move(state);
    now_.scene.film = film;
    now_.scene.revision = ++revision_;
    emit sceneChanged(now_.scene, moving);
}

void Document::comeBackTo(State state) {
    gesture_ = Gesture::none;
    if (state.edit == now_.edit)
        now_.brightness = state.brightness;
    else
        show(std::move(state), false);
    emit displayChanged(display());
}

/// Without a volume the choice waits for one.
void Document::applyPreset() {
    if (hasVolume()) {
        State state = now_;
        state.scene = withPreset(std::move(state.scene), presets_[std::size_t(state.preset)]);
        edit(std::move(state), false);
    }
    emit displayChanged(display());
}

/// The lights hang on the camera, so they are made anew with it.
void Document::applyCamera(const Camera& camera, bool moving) {
    State state = now_;
    state.scene.camera = camera;
    state.scene.lights = lightRig(presets_[std::size_t(state.preset)], state.scene.volume->geometry(), camera);
    edit(std::move(state), moving);
}

Camera Document::cameraOf(StandardView view) const {
    const VolumeGeometry& geometry = now_.scene.volume->geometry();
    const double aspect = double(now_.scene.film.x) / now_.scene.film.y;
    return fittedView(standardView(view, geometry.centreMm(), geometry.radiusMm(), aspect), geometry, aspect, kFilled);
}

}  // namespace pdr::app
