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

Document::Document(std::vector<NamedLook> looks)
    : drawnLooks_(std::move(looks)), looks_(drawnLooks_), brightness_(looks_.size()) {
    assert(!looks_.empty());
    setup_ = withNamedLook(setup_, looks_.front(), {});
    setup_.clip = {};
}

int Document::look() const {
    for (std::size_t i = 0; i < looks_.size(); ++i)
        if (looks_[i].name == setup_.lookName && looks_[i].look == setup_.look && looks_[i].model == setup_.model)
            return int(i);
    return -1;
}

std::string Document::whyUnsuited(int look) const {
    return findings_ ? pdr::whyUnsuited(looks_[std::size_t(look)], *findings_) : "";
}

void Document::open(std::shared_ptr<const Volume> volume, const segment::HiddenTable& table,
                    const std::optional<segment::Findings>& findings) {
    close();
    volume_ = std::move(volume);
    table_ = table;
    setup_.table = Table::hidden;
    setup_.clip = {};  // places in another patient
    findings_ = findings;
    takeLookThatSuits();
    setup_.camera = cameraOf(firstView(framed().box), {});
    show(false);
    emit displayChanged(display());
}

void Document::fitLooks() {
    looks_ = drawnLooks_;
    brightness_.assign(looks_.size(), std::nullopt);
    if (findings_ && findings_->blood)
        for (NamedLook& one : looks_)
            one = fittedTo(std::move(one), *findings_->blood);
}

void Document::setLooks(std::vector<NamedLook> looks) {
    assert(!looks.empty());
    drawnLooks_ = std::move(looks);
    fitLooks();
    emit displayChanged(display());
}

/// A look that the user has changed stays as it is.
void Document::takeLookThatSuits() {
    int shown = look();
    fitLooks();
    if (shown < 0)
        return;
    for (int i = 0; i < int(looks_.size()) && !whyUnsuited(shown).empty(); ++i)
        if (whyUnsuited(i).empty())
            shown = i;
    setup_ = withNamedLook(setup_, looks_[std::size_t(shown)], table_.bodyBox);
    setup_.stops = 0;
}

void Document::suggestBrightness(int look, double stops) {
    if (!hasVolume() || look < 0 || look >= int(looks_.size()) || brightness_[std::size_t(look)] ||
        looks_[std::size_t(look)].group == LookGroup::own)  // whose brightness somebody has chosen
        return;
    brightness_[std::size_t(look)] = stops;
    if (look != this->look() || setup_.stops != 0)
        return;
    for (PictureSetup& earlier : past_)  // so that undo does not lead back to a brightness that nobody chose
        if (earlier.lookName == setup_.lookName && earlier.stops == 0)
            earlier.stops = stops;
    setup_.stops = stops;
    emit displayChanged(display());
}

/// The setup without what the look, if it is one, has cut away.
PictureSetup Document::withoutCutOf(int look) const {
    PictureSetup setup = setup_;
    if (look >= 0 && looks_[std::size_t(look)].cut && hasVolume())
        std::erase(setup.clip.planes, planeOf(*looks_[std::size_t(look)].cut, table_.bodyBox));
    return setup;
}

PictureSetup Document::setupWith(int look) const {
    PictureSetup setup = withNamedLook(withoutCutOf(this->look()), looks_[std::size_t(look)], table_.bodyBox);
    setup.stops = brightness_[std::size_t(look)].value_or(0);
    if (!hasVolume())
        setup.clip = {};  // it is cut when it is there
    return setup;
}

void Document::open(std::shared_ptr<const Volume> volume) {
    segment::HiddenTable nothing;
    nothing.bodyBox = volume->geometry();
    open(std::move(volume), nothing);
}

void Document::close() {
    setup_ = withoutCutOf(look());
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

void Document::chooseLook(int index) {
    if (index < 0 || index >= int(looks_.size()))
        return;
    edit(setupWith(index));
    emit displayChanged(display());
}

void Document::setLook(const Look& look, bool moving) {
    if (look == setup_.look && !moving)
        return rest(Gesture::look);
    PictureSetup setup = setup_;
    setup.look = look;
    setup.lookName = nameOf(setup);
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

/// What was chosen cannot be seen. Where the choice was all that its step changed, there is no such step.
void Document::fallBackTo(const Visible& visible) {
    if (visible == setup_.look.visible)
        return;
    setup_.look.visible = visible;
    setup_.lookName = nameOf(setup_);
    if (canUndo() && past_.back() == setup_)
        past_.pop_back();
    if (hasVolume())
        show(false);
}

void Document::setSetup(const PictureSetup& setup) {
    if (setup == setup_)
        return;
    PictureSetup named = setup;
    named.lookName = nameOf(setup);
    edit(std::move(named));
    emit displayChanged(display());
}

/// A picture must not bear the name of a look that it does not show.
std::string Document::nameOf(const PictureSetup& setup) const {
    const std::string changed = tr(" (changed)").toStdString();
    for (const NamedLook& one : looks_)
        if (one.look == setup.look && one.model == setup.model)
            return one.name;
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
