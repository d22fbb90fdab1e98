#include "app/presenters/image_marks.h"

#include <chrono>

namespace pdr::app {
namespace {

/// What lies in front is computed once edits rest, since it takes time from the image.
constexpr auto kAtRest = std::chrono::milliseconds(250);

/// How far before a place it is looked for what hides it [mm]: the surface on which it lies does not.
constexpr double kBeforeMm = 2;

dvec3 before(dvec3 placeMm, const Camera& camera) {
    if (camera.type == Camera::Type::orthographic)
        return placeMm - kBeforeMm * camera.forward();
    return placeMm + kBeforeMm * glm::normalize(camera.eyeMm - placeMm);
}

/// Returns where it is looked for what hides a mark: its places, and the middles of the parts of its curves.
std::vector<dvec3> placesOf(const ui::ShownMark& mark, const Camera& camera) {
    std::vector<dvec3> places = mark.placesMm;
    for (const ui::MarkCurve& curve : curvesOf(mark, camera, false))
        for (std::size_t i = 0; i + 1 < curve.size(); ++i)
            places.push_back(0.5 * (curve[i] + curve[i + 1]));
    return places;
}

}  // namespace

ImageMarks::ImageMarks(const Workspace& workspace, PlaceScenes& scenes)
    : workspace_(workspace), job_(scenes), drops_(workspace, scenes) {
    workspace_.window.viewport().tools().add(layer_);
    atRest_.setSingleShot(true);
    atRest_.setInterval(kAtRest);
    connect(&atRest_, &QTimer::timeout, this, &ImageMarks::look);
    connect(&job_, &PlaceJob::seen, this,
            [this](const std::vector<dvec3>&, const std::vector<std::optional<HiddenBy>>& hidden) { show(hidden); });
    connectDrags();
}

void ImageMarks::connectDrags() {
    connect(&layer_, &ui::MarksLayer::dropped, this, [this](std::uint64_t id, int index, QPointF at) {
        dropped_ = {id, index};
        drops_.pick(at);
    });
    connect(&drops_, &ImagePick::picked, this,
            [this](const PickedPlace& place) { emit moved(dropped_.id, dropped_.index, place); });
    connect(&drops_, &ImagePick::unclear, &layer_, &ui::MarksLayer::putBack);
    connect(&layer_, &ui::MarksLayer::dragCancelled, &drops_, &ImagePick::drop);
}

void ImageMarks::setMarks(const std::vector<ui::ShownMark>& marks) {
    layer_.setMarks(marks);
    atRest_.start();
}

void ImageMarks::showDocument(Changes changes) {
    if (has(changes, kHides))
        atRest_.start();
}

void ImageMarks::releaseVolume() {
    atRest_.stop();
    job_.drop();
    drops_.drop();
    layer_.setHidden({});
}

void ImageMarks::look() {
    looked_ = layer_.marks();
    if (!workspace_.document.hasVolume() || looked_.empty())
        return;
    const Scene& scene = workspace_.document.scene();
    std::vector<dvec3> places;
    for (const ui::ShownMark& mark : looked_)
        for (const dvec3& place : placesOf(mark, scene.camera))
            places.push_back(before(place, scene.camera));
    job_.look(scene, places);
}

/// Shows what was found, in the order of placesOf() of each mark.
void ImageMarks::show(const std::vector<std::optional<HiddenBy>>& hidden) {
    std::size_t next = 0;
    const auto isHidden = [&] {
        const std::optional<HiddenBy>& by = hidden[next++];
        return by && by->hidden();
    };
    std::map<std::uint64_t, ui::MarkHidden> found;
    for (const ui::ShownMark& mark : looked_) {
        ui::MarkHidden& its = found[mark.id];
        for (std::size_t i = 0; i < mark.placesMm.size(); ++i)
            its.places.push_back(isHidden());
        for (const ui::MarkCurve& curve : curvesOf(mark, workspace_.document.scene().camera, false)) {
            std::vector<bool>& parts = its.parts.emplace_back();
            for (std::size_t i = 0; i + 1 < curve.size(); ++i)
                parts.push_back(isHidden());
        }
    }
    layer_.setHidden(std::move(found));
}

}  // namespace pdr::app
