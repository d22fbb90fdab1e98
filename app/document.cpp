#include "app/document.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "render/scene/camera_edits.h"

namespace pdr::app {
namespace {

constexpr double kFilled = 0.92;     ///< fraction of the picture that the volume takes; the rest is for the letters
constexpr int kLargestFilm = 16384;  ///< pixels along a side that a Scene takes

}  // namespace

Document::Document(std::vector<Preset> presets) : presets_(std::move(presets)) {
    assert(!presets_.empty());
    setup_.look = presets_.front().look;
    setup_.lookName = presets_.front().name;
}

int Document::preset() const {
    for (std::size_t i = 0; i < presets_.size(); ++i)
        if (presets_[i].name == setup_.lookName && presets_[i].look == setup_.look)
            return int(i);
    return -1;
}

void Document::open(std::shared_ptr<const Volume> volume, const segment::HiddenTable& table) {
    forgetSteps();
    masks_.clear();
    shown_ = {};
    volume_ = std::move(volume);
    table_ = table;
    setup_.table = Table::hidden;
    setup_.clip = {};  // places in another patient
    setup_.camera = cameraOf(firstView(framed().box), {});
    show(false);
    emit displayChanged(display());
}

void Document::open(std::shared_ptr<const Volume> volume) {
    segment::HiddenTable nothing;
    nothing.bodyBox = volume->geometry();
    open(std::move(volume), nothing);
}

void Document::close() {
    forgetSteps();
    volume_.reset();
    table_ = {};
    masks_.clear();
    shown_ = {};
    scene_.volume.reset();
    scene_.mask.reset();
}

void Document::setCamera(const Camera& camera, bool moving) {
    if (!hasVolume())
        return;
    if (camera == setup_.camera && !moving)
        return rest(Gesture::camera);
    PictureSetup setup = setup_;
    setup.camera = camera;
    edit(std::move(setup), Gesture::camera, moving);
}

/// A gesture ends where it has led: no other scene. Where it was another gesture there is nothing new at all.
void Document::rest(Gesture gesture) {
    if (std::exchange(gesture_, Gesture::none) == gesture)
        emit sceneChanged(scene_, false);
}

void Document::setView(StandardView view) {
    setCamera(hasVolume() ? cameraOf(view, setup_.camera) : Camera{}, false);
}

void Document::setFocus(double depthMm) {
    setCamera(focusedAt(setup_.camera, depthMm), false);
}

void Document::resetView() {
    if (hasVolume())
        setCamera(cameraOf(firstView(framed().box), {}), false);
}

void Document::setBackground(const std::optional<vec3>& radiance) {
    PictureSetup setup = setup_;
    setup.background = radiance;
    if (!radiance)
        setup.look.environment.visible = true;
    if (setup != setup_)
        edit(std::move(setup));
}

/// Exposure Render's ways know one event on a path only.
void Document::setModel(Model model) {
    if (model == setup_.model)
        return;
    PictureSetup setup = setup_;
    setup.model = model;
    if (model != Model::singleScattering)
        setup.estimator = Estimator::unbiased;
    edit(std::move(setup));
}

void Document::setTable(Table table) {
    if (table == setup_.table || !hasTable())
        return;
    PictureSetup setup = setup_;
    setup.table = table;
    edit(std::move(setup));
}

void Document::setPreset(int index) {
    if (index < 0 || index >= int(presets_.size()))
        return;
    PictureSetup setup = setup_;
    setup.look = presets_[std::size_t(index)].look;
    setup.lookName = presets_[std::size_t(index)].name;
    setup.stops = 0;
    edit(std::move(setup));
    emit displayChanged(display());
}

void Document::setLook(const Look& look, bool moving) {
    if (look == setup_.look && !moving)
        return rest(Gesture::look);
    PictureSetup setup = setup_;
    setup.look = look;
    setup.lookName = nameOf(look);
    edit(std::move(setup), Gesture::look, moving);
    emit displayChanged(display());
}

void Document::setClip(const Clip& clip, bool moving) {
    if (!hasVolume())
        return;
    if (clip == setup_.clip && !moving)
        return rest(Gesture::clip);
    PictureSetup setup = setup_;
    setup.clip = clip;
    edit(std::move(setup), Gesture::clip, moving);
}

void Document::giveUpGesture() {
    if (std::exchange(gesture_, Gesture::none) == Gesture::none || past_.empty())
        return;
    PictureSetup setup = std::move(past_.back());
    past_.pop_back();
    comeBackTo(std::move(setup));
}

void Document::setVisible(const Visible& visible, bool moving) {
    Look look = setup_.look;
    look.visible = visible;
    setLook(look, moving);
}

void Document::setMask(const Visible& visible, const std::shared_ptr<const Mask>& mask) {
    masks_.push_back({visible, mask});
    if (masks_.size() > kMasks)
        masks_.pop_front();
    if (hasVolume() && visible == setup_.look.visible)
        show(false);
}

void Document::keepVisible() {
    if (shown_.visible == setup_.look.visible)
        return;
    setup_.look.visible = shown_.visible;
    setup_.lookName = nameOf(setup_.look);
    if (hasVolume())
        show(false);
}

void Document::setSetup(const PictureSetup& setup) {
    if (setup == setup_)
        return;
    PictureSetup named = setup;
    named.lookName = nameOf(setup.look);
    edit(std::move(named));
    emit displayChanged(display());
}

/// A picture must not bear the name of a preset that it does not show.
std::string Document::nameOf(const Look& look) const {
    const std::string changed = tr(" (changed)").toStdString();
    for (const Preset& preset : presets_)
        if (preset.look == look)
            return preset.name;
    return setup_.lookName.ends_with(changed) ? setup_.lookName : setup_.lookName + changed;
}

void Document::setEstimator(Estimator estimator) {
    if (estimator == setup_.estimator)
        return;
    PictureSetup setup = setup_;
    setup.estimator = estimator;
    edit(std::move(setup));
}

void Document::setSchedule(const Schedule& schedule) {
    if (schedule == setup_.schedule)
        return;
    PictureSetup setup = setup_;
    setup.schedule = schedule;
    edit(std::move(setup));
}

void Document::setBrightness(double stops, bool moving) {
    if (stops == setup_.stops && gesture_ != Gesture::brightness)
        return;
    remember(Gesture::brightness, moving);
    setup_.stops = stops;
    emit displayChanged(display());
}

Display Document::display() const {
    Display display = displayOf(setup_);
    display.smoothed = smoothed_;
    return display;
}

void Document::setSmoothed(bool smoothed) {
    if (smoothed == smoothed_)
        return;
    smoothed_ = smoothed;
    emit displayChanged(display());
}

void Document::setViewSize(ivec2 pixels) {
    const ivec2 film = glm::clamp(pixels, ivec2(1), ivec2(kLargestFilm));
    if (film == film_)
        return;
    film_ = film;
    show(false);
}

void Document::undo() {
    if (!canUndo())
        return;
    future_.push_back(setup_);
    PictureSetup setup = std::move(past_.back());
    past_.pop_back();
    comeBackTo(std::move(setup));
}

void Document::redo() {
    if (!canRedo())
        return;
    past_.push_back(setup_);
    PictureSetup setup = std::move(future_.back());
    future_.pop_back();
    comeBackTo(std::move(setup));
}

/// What stands now becomes a step to undo, unless `gesture` goes on. Without a volume there is nothing to go back to.
void Document::remember(Gesture gesture, bool moving) {
    const bool continues = gesture != Gesture::none && gesture == gesture_;
    gesture_ = moving ? gesture : Gesture::none;
    if (continues || !hasVolume())
        return;
    past_.push_back(setup_);
    if (past_.size() > kSteps)
        past_.pop_front();
    future_.clear();
}

void Document::forgetSteps() {
    past_.clear();
    future_.clear();
    gesture_ = Gesture::none;
}

void Document::edit(PictureSetup setup, Gesture gesture, bool moving) {
    remember(gesture, moving);
    setup_ = std::move(setup);
    show(moving);
}

/// The revision is not undone: an earlier setup comes back as a new scene, unless only what is shown was another.
void Document::comeBackTo(PictureSetup setup) {
    gesture_ = Gesture::none;
    setup_ = std::move(setup);
    Scene scene = made();
    scene.revision = scene_.revision;
    if (scene != scene_)
        show(std::move(scene), false);
    emit displayChanged(display());
}

/// Without a volume what was set up waits for one.
void Document::show(bool moving) {
    if (hasVolume())
        show(made(), moving);
}

void Document::show(Scene scene, bool moving) {
    const std::uint64_t revision = scene_.revision + 1;
    scene_ = std::move(scene);
    scene_.revision = revision;
    emit sceneChanged(scene_, moving);
    if (shown_.visible != setup_.look.visible)
        emit maskWanted(hasTable() ? table_.body : volume_, setup_.look.visible);
}

/// The scene of the setup, with the newest mask that is known.
Scene Document::made() {
    const Visible& visible = setup_.look.visible;
    const auto known = std::ranges::find(masks_, visible, &PartMask::visible);
    if (visible.all())
        shown_ = {};
    else if (known != masks_.end())
        shown_ = *known;
    Scene scene = sceneOf(setup_, seen(), film_);
    scene.mask = shown_.mask;
    return scene;
}

const std::shared_ptr<const Volume>& Document::seen() const {
    return setup_.table == Table::hidden && hasTable() ? table_.body : volume_;
}

/// What a view is filled with.
Framed Document::framed() const {
    if (setup_.table == Table::hidden)
        return {table_.bodyBox, table_.outlineMm};
    return {volume_->geometry(), nullptr};
}

std::optional<ClipBox> Document::uncut() const {
    return hasVolume() ? std::optional(boxAround(framed().box)) : std::nullopt;
}

Camera Document::cameraOf(StandardView view, const Camera& lens) const {
    return fittedView(view, framed(), double(film_.x) / film_.y, kFilled, lens);
}

}  // namespace pdr::app
