#include "app/document/document.h"

#include <utility>

#include "render/base/image_size.h"
#include "render/scene/edit/camera_edits.h"
#include "render/volume/value_unit.h"

namespace pdr::app {

Document::Document(std::vector<NamedLook> looks) : looks_(std::move(looks)) {
    plan_.image = withNamedLook(setup(), looks_[0], {});
    plan_.image.clip = {};
}

void Document::arrive(std::shared_ptr<const ArrivingVolume> volume, const GreyWindow& window) {
    const Plan before = plan_;
    closeVolume();
    arriving_ = std::move(volume);
    wasSeen_ = false;
    firstWindow_ = window;
    plan_.navigation = firstNavigation(arriving_->geometry());
    report(before, Changes::arrival);
}

void Document::seeArrived() {
    wasSeen_ = true;
}

/// Returns what slices show at first of a scan with that body.
Navigation Document::firstNavigation(const VolumeGeometry& bodyBox) const {
    return {.crosshairMm = bodyBox.centreMm(), .window = firstWindow_, .layout = plan_.navigation.layout};
}

void Document::open(std::shared_ptr<const Volume> volume, const segment::HiddenTable& table,
                    const std::optional<segment::Findings>& findings, std::shared_ptr<const HiddenVoxels> hidden,
                    const GreyWindow& window) {
    const Plan before = plan_;
    const bool wasSeen = std::exchange(arriving_, nullptr) && wasSeen_;
    closeVolume();
    volume_ = std::move(volume);
    table_ = table;
    hidden_ = std::move(hidden);
    parts_ = std::make_shared<const segment::BodyParts>(volume_);
    plan_.image.table = Table::hidden;
    plan_.image.clip = {};  // its coordinates belong to another patient
    fitLooksTo(findings);
    plan_.image.camera = cameraOf(firstView(framed().box), {});
    plan_.measurements.clear();
    firstWindow_ = window;
    if (!wasSeen)
        plan_.navigation = firstNavigation(table_.bodyBox);
    show(false);
    report(before, Changes::series | Changes::looks);
}

void Document::setLooks(std::vector<NamedLook> looks) {
    looks_.replace(std::move(looks));
    report(plan_, Changes::looks);
}

/// Fits the looks to the volume. A look that the user has changed stays as it is, from one scan in HU to another:
/// values that are no HU mean something else in each scan.
void Document::fitLooksTo(const std::optional<segment::Findings>& findings) {
    const int shown = look();
    const bool wereInHu = looks_.areInHu();
    if (unitOf(*volume_).isHu)
        looks_.fitTo(findings);
    else
        looks_.fitToValues(spreadOf(*volume_));
    const bool stayInHu = wereInHu && looks_.areInHu();
    if (stayInHu && shown < 0)
        return;
    plan_.image = withNamedLook(setup(), looks_[looks_.suitedOr(stayInHu ? shown : 0)], table_.bodyBox);
    plan_.image.stops = 0;
}

void Document::suggestBrightness(int look, double stops) {
    if (!hasVolume() || !looks_.holds(look) || !looks_.suggestStops(look, stops))
        return;
    if (look != this->look() || setup().stops != 0)
        return;
    const Plan before = plan_;
    history_.brighten(setup().lookName, stops);  // so that undo does not lead back to a brightness that nobody chose
    plan_.image.stops = stops;
    report(before);
}

/// Returns the setup without the cut of `look`; -1: no look, nothing is removed.
ImageSetup Document::withoutCutOf(int look) const {
    ImageSetup setup = this->setup();
    if (look >= 0 && looks_[look].cut && hasVolume())
        std::erase(setup.clip.planes, planeOf(*looks_[look].cut, table_.bodyBox));
    return setup;
}

ImageSetup Document::setupWith(int look) const {
    ImageSetup setup = withNamedLook(withoutCutOf(this->look()), looks_[look], table_.bodyBox);
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
    const Plan before = plan_;
    closeVolume();
    report(before, Changes::series);
}

void Document::closeVolume() {
    // From here on there is no volume, so that a job that is cancelled by closing() makes no scene of it
    const std::shared_ptr<const Volume> volume = std::exchange(volume_, nullptr);
    const std::shared_ptr<const ArrivingVolume> arriving = std::exchange(arriving_, nullptr);
    if (volume || arriving)
        emit closing();
    plan_.image = withoutCutOf(look());
    history_.forget();
    table_ = {};
    hidden_.reset();
    parts_.reset();
    masks_.clear();
    denoisedScan_.clear();
    knownParts_.clear();
    plan_.partSources = {};
    scene_.volume.reset();
    scene_.mask.reset();
    scene_.parts = {};
}

void Document::setCamera(const Camera& camera, bool moving) {
    if (hasVolume())
        setField(&ImageSetup::camera, camera, Changes::camera, moving);
}

void Document::setView(StandardView view) {
    setCamera(hasVolume() ? cameraOf(view, setup().camera) : Camera{}, false);
}

void Document::setFocus(double depthMm) {
    setCamera(focusedAt(setup().camera, depthMm), false);
}

void Document::resetView() {
    if (hasVolume())
        setCamera(cameraOf(firstView(framed().box), {}), false);
}

void Document::setBackground(const std::optional<vec3>& radiance) {
    ImageSetup setup = plan_.image;
    setup.background = radiance;
    if (!radiance)
        setup.look.environment.visible = true;
    edit(std::move(setup));
}

/// Resets the estimator with any model but single scattering: Exposure Render's estimators know one event per path
/// only.
void Document::setModel(Model model) {
    ImageSetup setup = plan_.image;
    setup.model = model;
    if (model != plan_.image.model && model != Model::singleScattering)
        setup.estimator = Estimator::unbiased;
    edit(std::move(setup));
}

void Document::setTable(Table table) {
    if (hasTable())
        setField(&ImageSetup::table, table);
}

void Document::chooseLook(int index) {
    if (!looks_.holds(index))
        return;
    edit(setupWith(index));
}

void Document::setLook(const Look& look, bool moving) {
    ImageSetup setup = plan_.image;
    setup.look = look;
    edit(looks_.named(std::move(setup), plan_.image.lookName), Changes::look, moving);
}

void Document::setClip(const Clip& clip, bool moving) {
    if (hasVolume())
        setField(&ImageSetup::clip, clip, Changes::clip, moving);
}

void Document::giveUpGesture() {
    if (history_.gesture() == Changes::navigation)
        return;  // its moves are one step, but none of them is in progress
    if (std::optional<Plan> begun = history_.giveUpGesture())
        comeBackTo(std::move(*begun));
}

void Document::setVisible(const Visible& visible, bool moving) {
    Look look = setup().look;
    look.visible = visible;
    setLook(look, moving);
}

void Document::setMask(const Visible& visible, const std::shared_ptr<const Mask>& mask) {
    if (!mask)
        return visible == setup().look.visible ? fallBackTo(Visible{}) : void();
    masks_.add(visible, mask);
    if (!hasVolume() || visible != setup().look.visible)
        return;
    show(false);
    report(plan_, Changes::mask);
}

void Document::keepVisible() {
    fallBackTo(masks_.shown());
}

void Document::setCtDenoised(bool denoised) {
    Look look = setup().look;
    look.ctDenoised = denoised;
    setLook(look);
}

void Document::takeDenoisedCt(const std::shared_ptr<const Volume>& scan,
                              const std::shared_ptr<const Volume>& denoised) {
    if (!hasVolume() || scan != seen())
        return;
    denoisedScan_.take(scan, denoised);
    if (!setup().look.ctDenoised)
        return;
    show(false);
    report(plan_, Changes::mask);
}

void Document::keepNoise() {
    Look look = setup().look;
    look.ctDenoised = false;
    fallBackTo(look);
}

void Document::setParts(const PartSources& sources, const std::shared_ptr<const ScanParts>& parts) {
    if (!hasVolume())
        return;
    if (parts)
        knownParts_.add(sources, parts);
    Plan plan = plan_;
    plan.partSources = sources;
    edit(std::move(plan));
}

void Document::takeParts(const PartSources& sources, const std::shared_ptr<const ScanParts>& parts) {
    if (!hasVolume())
        return;
    knownParts_.add(sources, parts);
    if (sources != plan_.partSources)
        return;
    show(false);
    report(plan_, Changes::mask);
}

void Document::keepParts() {
    fallBackTo(knownParts_.shown());
}

void Document::dropLabels() {
    PartSources sources = plan_.partSources;
    sources.labels.clear();
    fallBackTo(sources);
}

/// As fallBackTo() of a look.
void Document::fallBackTo(const PartSources& sources) {
    if (sources == plan_.partSources)
        return;
    const Plan before = plan_;
    plan_.partSources = sources;
    history_.forgetStepTo(plan_);
    show(false);
    report(before, Changes::mask);
}

void Document::fallBackTo(const Visible& visible) {
    Look look = setup().look;
    look.visible = visible;
    fallBackTo(look);
}

/// Replaces a choice that cannot be shown by `look`. If the choice was all that its undo step changed, the step is
/// removed.
void Document::fallBackTo(const Look& look) {
    if (look == setup().look)
        return;
    const Plan before = plan_;
    plan_.image.look = look;
    plan_.image = looks_.named(setup(), setup().lookName);
    history_.forgetStepTo(plan_);
    show(false);
    report(before, Changes::mask);
}

void Document::setSetup(const ImageSetup& setup) {
    edit(looks_.named(setup, plan_.image.lookName));
}

void Document::setEstimator(Estimator estimator) {
    setField(&ImageSetup::estimator, estimator);
}

void Document::setSchedule(const Schedule& schedule) {
    setField(&ImageSetup::schedule, schedule);
}

void Document::setBrightness(double stops, bool moving) {
    if (stops == setup().stops && history_.gesture() != Changes::brightness)
        return;
    const Plan before = plan_;
    remember(Changes::brightness, moving);
    plan_.image.stops = stops;
    report(before);
}

Display Document::display() const {
    Display display = displayOf(setup());
    display.denoised = denoised_;
    return display;
}

void Document::setDenoised(bool denoised) {
    if (denoised == denoised_)
        return;
    denoised_ = denoised;
    report(plan_, Changes::display);
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
        comeBackTo(history_.undo(plan_));
}

void Document::redo() {
    if (canRedo())
        comeBackTo(history_.redo(plan_));
}

Text Document::undoText() const {
    return app::undoText(canUndo() ? history_.previous() : plan_, plan_);
}

Text Document::redoText() const {
    return app::redoText(plan_, canRedo() ? history_.next() : plan_);
}

void Document::moveCrosshair(dvec3 placeMm) {
    Navigation navigation = plan_.navigation;
    navigation.crosshairMm = placeMm;
    navigate(navigation);
}

void Document::navigate(const Navigation& navigation) {
    if (navigation == plan_.navigation)
        return;
    Plan plan = plan_;
    plan.navigation = navigation;
    edit(std::move(plan), Changes::navigation, true);
}

/// Records the current plan as a step to undo; without a volume there is nothing to return to.
void Document::remember(Changes gesture, bool moving) {
    if (hasVolume())
        history_.remember(plan_, gesture, moving);
}

template <typename Field>
void Document::setField(Field ImageSetup::*field, const Field& value, Changes gesture, bool moving) {
    ImageSetup setup = plan_.image;
    setup.*field = value;
    edit(std::move(setup), gesture, moving);
}

void Document::edit(ImageSetup image, Changes gesture, bool moving) {
    Plan plan = plan_;
    plan.image = std::move(image);
    edit(std::move(plan), gesture, moving);
}

/// If the edit changes nothing and ends the gesture in progress, the same scene is reported once more, now at rest. If
/// another gesture was in progress, nothing is reported.
void Document::edit(Plan plan, Changes gesture, bool moving) {
    if (plan == plan_ && !moving) {
        if (history_.end(gesture))
            emit sceneChanged(scene_, false);
        return;
    }
    remember(gesture, moving);
    const Plan before = std::exchange(plan_, std::move(plan));
    if (plan_.image != before.image || (moving && plan_ == before))
        show(moving);
    else if (plan_.partSources != before.partSources)
        showIfOther();
    report(before);
}

/// Restores an earlier plan. The revision is not restored: the plan comes back as a new scene, unless only the display
/// or nothing of the image differs.
void Document::comeBackTo(Plan plan) {
    const Plan before = std::exchange(plan_, std::move(plan));
    showIfOther();
    report(before);
}

/// Emits what an operation has changed since the plan was `before`, and `also`.
void Document::report(const Plan& before, Changes also) {
    if (displayOf(before.image) != displayOf(setup()) || has(also, Changes::display | Changes::series))
        emit displayChanged(display());
    emit changed(changesBetween(before, plan_) | also);
}

/// Shows the scene of the plan unless it is the one that is shown.
void Document::showIfOther() {
    Scene scene = made();
    scene.revision = scene_.revision;
    if (scene != scene_)
        show(std::move(scene), false);
}

/// Shows the scene of the plan. Without a volume, the plan waits for one.
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
    if (masks_.shown() != setup().look.visible)
        emit maskWanted(parts_, setup().look.visible);
    if (setup().look.ctDenoised && !denoisedScan_.of(seen()))
        emit denoisedCtWanted(scene_.volume);
    if (knownParts_.shown() != plan_.partSources)
        emit partsWanted(plan_.partSources);
}

/// Builds the scene of the plan. Its mask and its parts are those of the choice if they are known, else those shown so
/// far.
Scene Document::made() {
    masks_.show(setup().look.visible);
    knownParts_.show(plan_.partSources);
    Scene scene = sceneOf(setup(), shownVolume(), film_, scanParts() ? scanParts()->map : nullptr);
    scene.mask = masks_.mask();
    scene.maskAwaited = masks_.shown() != setup().look.visible;
    if (knownParts_.shown() != plan_.partSources)
        scene.maskAwaited = true;
    return scene;
}

/// Returns the volume of the plan's scene: what is seen, with less noise if that is wanted and known.
std::shared_ptr<const Volume> Document::shownVolume() const {
    std::shared_ptr<const Volume> scan = seen();
    std::shared_ptr<const Volume> denoised = setup().look.ctDenoised ? denoisedScan_.of(scan) : nullptr;
    return denoised ? denoised : scan;
}

std::shared_ptr<const Volume> Document::seen() const {
    if (setup().table == Table::hidden || !hasTable())
        return volume_;
    std::shared_ptr<const Volume> scan = withTable_.lock();
    if (!scan)
        withTable_ = scan = std::make_shared<const Volume>(hidden_->scanOf(*volume_));
    return scan;
}

/// Returns what a view is fitted to: the body, or the whole grid if the table is shown.
Framed Document::framed() const {
    if (setup().table == Table::hidden)
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
