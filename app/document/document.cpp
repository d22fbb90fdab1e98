#include "app/document/document.h"

#include <algorithm>
#include <utility>

#include "render/base/image_size.h"
#include "render/scene/edit/camera_edits.h"

namespace pdr::app {
Document::Document(std::vector<NamedLook> looks) : looks_(std::move(looks)) {
    setup_ = withNamedLook(setup_, looks_[0], {});
    setup_.clip = {};
}

void Document::open(std::shared_ptr<const Volume> volume, const segment::HiddenTable& table,
                    const std::optional<segment::Findings>& findings, std::shared_ptr<const HiddenVoxels> hidden) {
    close();
    volume_ = std::move(volume);
    table_ = table;
    hidden_ = std::move(hidden);
    parts_ = std::make_shared<const segment::BodyParts>(volume_);
    setup_.table = Table::hidden;
    setup_.clip = {};  // its coordinates belong to another patient
    fitLooksTo(findings);
    setup_.camera = cameraOf(firstView(framed().box), {});
    show(false);
    emit displayChanged(display());
}

void Document::setLooks(std::vector<NamedLook> looks) {
    looks_.replace(std::move(looks));
    emit looksChanged();
    emit displayChanged(display());
}

/// Fits the looks to the volume. A look that the user has changed stays as it is.
void Document::fitLooksTo(const std::optional<segment::Findings>& findings) {
    const int shown = look();
    looks_.fitTo(findings);
    emit looksChanged();
    if (shown < 0)
        return;
    setup_ = withNamedLook(setup_, looks_[looks_.suitedOr(shown)], table_.bodyBox);
    setup_.stops = 0;
}

void Document::suggestBrightness(int look, double stops) {
    if (!hasVolume() || !looks_.holds(look) || !looks_.suggestStops(look, stops))
        return;
    if (look != this->look() || setup_.stops != 0)
        return;
    history_.brighten(setup_.lookName, stops);  // so that undo does not lead back to a brightness that nobody chose
    setup_.stops = stops;
    emit displayChanged(display());
}

/// Returns the setup without the cut of `look`; -1: no look, nothing is removed.
PictureSetup Document::withoutCutOf(int look) const {
    PictureSetup setup = setup_;
    if (look >= 0 && looks_[look].cut && hasVolume())
        std::erase(setup.clip.planes, planeOf(*looks_[look].cut, table_.bodyBox));
    return setup;
}

PictureSetup Document::setupWith(int look) const {
    PictureSetup setup = withNamedLook(withoutCutOf(this->look()), looks_[look], table_.bodyBox);
    setup.stops = looks_.stops(look);
    if (!hasVolume())
        setup.clip = {};  // open() applies the look's cut
    return setup;
}

void Document::open(std::shared_ptr<const Volume> volume) {
    segment::HiddenTable nothing;
    nothing.bodyBox = volume->geometry();
    open(std::move(volume), nothing);
}

void Document::close() {
    if (hasVolume())
        emit closing();
    setup_ = withoutCutOf(look());
    history_.forget();
    volume_.reset();
    table_ = {};
    hidden_.reset();
    parts_.reset();
    masks_.clear();
    shown_ = {};
    scene_.volume.reset();
    scene_.mask.reset();
}

void Document::setCamera(const Camera& camera, bool moving) {
    if (hasVolume())
        setField(&PictureSetup::camera, camera, Gesture::camera, moving);
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
    edit(std::move(setup));
}

/// Resets the estimator with any model but single scattering: Exposure Render's estimators know one event per path
/// only.
void Document::setModel(Model model) {
    PictureSetup setup = setup_;
    setup.model = model;
    if (model != setup_.model && model != Model::singleScattering)
        setup.estimator = Estimator::unbiased;
    edit(std::move(setup));
}

void Document::setTable(Table table) {
    if (hasTable())
        setField(&PictureSetup::table, table);
}

void Document::chooseLook(int index) {
    if (!looks_.holds(index))
        return;
    edit(setupWith(index));
    emit displayChanged(display());
}

void Document::setLook(const Look& look, bool moving) {
    PictureSetup setup = setup_;
    setup.look = look;
    edit(looks_.named(std::move(setup), setup_.lookName), Gesture::look, moving);
    emit displayChanged(display());
}

void Document::setClip(const Clip& clip, bool moving) {
    if (hasVolume())
        setField(&PictureSetup::clip, clip, Gesture::clip, moving);
}

void Document::giveUpGesture() {
    if (std::optional<PictureSetup> begun = history_.giveUpGesture())
        comeBackTo(std::move(*begun));
}

void Document::setVisible(const Visible& visible, bool moving) {
    Look look = setup_.look;
    look.visible = visible;
    setLook(look, moving);
}

void Document::setMask(const Visible& visible, const std::shared_ptr<const Mask>& mask) {
    if (!mask)
        return visible == setup_.look.visible ? fallBackTo({}) : void();
    masks_.push_back({visible, mask});
    if (masks_.size() > kMasks)
        masks_.pop_front();
    if (hasVolume() && visible == setup_.look.visible)
        show(false);
}

void Document::keepVisible() {
    fallBackTo(shown_.visible);
}

/// Replaces a choice that cannot be shown by `visible`. If the choice was all that its undo step changed, the step is
/// removed.
void Document::fallBackTo(const Visible& visible) {
    if (visible == setup_.look.visible)
        return;
    setup_.look.visible = visible;
    setup_ = looks_.named(setup_, setup_.lookName);
    history_.forgetStepTo(setup_);
    if (hasVolume())
        show(false);
}

void Document::setSetup(const PictureSetup& setup) {
    edit(looks_.named(setup, setup_.lookName));
    emit displayChanged(display());
}

void Document::setEstimator(Estimator estimator) {
    setField(&PictureSetup::estimator, estimator);
}

void Document::setSchedule(const Schedule& schedule) {
    setField(&PictureSetup::schedule, schedule);
}

void Document::setBrightness(double stops, bool moving) {
    if (stops == setup_.stops && history_.gesture() != Gesture::brightness)
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

void Document::setNextFilm(ivec2 pixels) {
    nextFilm_ = glm::clamp(pixels, ivec2(1), ivec2(kLongestSide));
}

void Document::setViewSize(ivec2 pixels) {
    setNextFilm(pixels);
    if (nextFilm_ != film_)
        show(false);
}

void Document::undo() {
    if (canUndo())
        comeBackTo(history_.undo(setup_));
}

void Document::redo() {
    if (canRedo())
        comeBackTo(history_.redo(setup_));
}

/// Records the current setup as a step to undo; without a volume there is nothing to return to.
void Document::remember(Gesture gesture, bool moving) {
    if (hasVolume())
        history_.remember(setup_, gesture, moving);
}

template <typename Field>
void Document::setField(Field PictureSetup::*field, const Field& value, Gesture gesture, bool moving) {
    PictureSetup setup = setup_;
    setup.*field = value;
    edit(std::move(setup), gesture, moving);
}

/// Applies an edit. If it changes nothing and ends the gesture in progress, the same scene is reported once more, now
/// at rest. If another gesture was in progress, nothing is reported.
void Document::edit(PictureSetup setup, Gesture gesture, bool moving) {
    if (setup == setup_ && !moving) {
        if (history_.end(gesture))
            emit sceneChanged(scene_, false);
        return;
    }
    remember(gesture, moving);
    setup_ = std::move(setup);
    show(moving);
}

/// Restores an earlier setup. The revision is not restored: the setup comes back as a new scene, unless only the
/// display differs.
void Document::comeBackTo(PictureSetup setup) {
    setup_ = std::move(setup);
    Scene scene = made();
    scene.revision = scene_.revision;
    if (scene != scene_)
        show(std::move(scene), false);
    emit displayChanged(display());
}

/// Shows the scene of the setup. Without a volume, the setup waits for one.
void Document::show(bool moving) {
    if (hasVolume())
        show(made(), moving);
}

void Document::show(Scene scene, bool moving) {
    const std::uint64_t revision = scene_.revision + 1;
    scene_ = std::move(scene);
    scene_.revision = revision;
    scene_.film = film_ = nextFilm_;
    emit sceneChanged(scene_, moving);
    if (shown_.visible != setup_.look.visible)
        emit maskWanted(parts_, setup_.look.visible);
}

/// Builds the scene of the setup. Its mask is that of the choice if it is known, else the one shown so far.
Scene Document::made() {
    const Visible& visible = setup_.look.visible;
    const auto known = std::ranges::find(masks_, visible, &PartMask::visible);
    if (visible.all())
        shown_ = {};
    else if (known != masks_.end())
        shown_ = *known;
    Scene scene = sceneOf(setup_, seen(), film_);
    scene.mask = shown_.mask;
    scene.maskAwaited = shown_.visible != visible;
    return scene;
}

std::shared_ptr<const Volume> Document::seen() const {
    if (setup_.table == Table::hidden || !hasTable())
        return volume_;
    std::shared_ptr<const Volume> scan = withTable_.lock();
    if (!scan)
        withTable_ = scan = std::make_shared<const Volume>(hidden_->scanOf(*volume_));
    return scan;
}

/// Returns what a view is fitted to: the body, or the whole grid if the table is shown.
Framed Document::framed() const {
    if (setup_.table == Table::hidden)
        return {table_.bodyBox, table_.outlineMm};
    return {volume_->geometry(), nullptr};
}

std::optional<ClipBox> Document::uncut() const {
    return hasVolume() ? std::optional(boxAround(framed().box)) : std::nullopt;
}

Camera Document::cameraOf(StandardView view, const Camera& lens) const {
    return fittedView(view, framed(), double(nextFilm_.x) / nextFilm_.y, kViewFilled, lens);
}

}  // namespace pdr::app
