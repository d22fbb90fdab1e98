#include "app/document/document.h"

#include <utility>

#include "render/base/image_size.h"
#include "render/scene/edit/camera_edits.h"

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
    scan_ = OpenScan(std::move(volume), table, std::move(hidden));
    plan_.image.table = Table::hidden;
    plan_.image.clip = {};  // its coordinates belong to another patient
    fitLooksTo(findings);
    plan_.image.camera = cameraOf(firstView(framed().box), {});
    plan_.measurements.clear();
    firstWindow_ = window;
    if (!wasSeen)
        plan_.navigation = firstNavigation(bodyBox());
    show(false);
    report(before, Changes::series | Changes::looks);
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
    const std::shared_ptr<const Volume> volume = scan_.takeVolume();
    const std::shared_ptr<const ArrivingVolume> arriving = std::exchange(arriving_, nullptr);
    if (volume || arriving)
        emit closing();
    plan_.image = withoutCutOf(look());
    history_.forget();
    scan_ = {};
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

void Document::takeParts(const PartSources& sources, const std::shared_ptr<const ScanParts>& parts) {
    if (!hasVolume())
        return;
    scan_.parts().add(sources, parts);
    if (sources == plan_.partSources)
        showArrived();
}

void Document::fallBackTo(Plan plan) {
    if (plan == plan_)
        return;
    const Plan before = std::exchange(plan_, std::move(plan));
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
    Scene scene = scan_.sceneOf(plan_, film_);
    scene.revision = scene_.revision;
    if (scene != scene_)
        show(std::move(scene), false);
}

/// Shows the scene of the plan. Without a volume, the plan waits for one.
void Document::show(bool moving) {
    if (hasVolume())
        show(scan_.sceneOf(plan_, film_), moving);
}

/// Shows the scene of the plan with what it has been waiting for.
void Document::showArrived() {
    showIfOther();
    report(plan_, Changes::mask);
}

void Document::show(Scene scene, bool moving) {
    const std::uint64_t revision = scene_.revision + 1;
    scene_ = std::move(scene);
    scene_.revision = revision;
    scene_.film = film_ = nextFilm_;
    emit sceneChanged(scene_, moving);
    if (scan_.masks().shown() != setup().look.visible)
        emit maskWanted(parts(), setup().look.visible);
    if (setup().look.ctDenoised && !scan_.denoised().of(seen()))
        emit denoisedCtWanted(scene_.volume);
    if (scan_.parts().shown() != plan_.partSources)
        emit partsWanted(plan_.partSources);
}

std::optional<ClipBox> Document::uncut() const {
    return hasVolume() ? std::optional(boxAround(framed().box)) : std::nullopt;
}

Camera Document::cameraOf(StandardView view, const Camera& lens) const {
    return fittedView(view, framed(), double(nextFilm_.x) / nextFilm_.y, kViewFilled, lens);
}

}  // namespace pdr::app
