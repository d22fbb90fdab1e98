#include "app/jobs/place_job.h"

namespace pdr::app {

/// Calls `examine` with the prepared scene; the function that it returns tells the result. A scene that cannot be
/// rendered has none.
template <class Examine>
void PlaceJob::examine(const Scene& scene, Examine examine) {
    start(
        [scene, examine, shared = scenes_.current()](const Progress&, const std::stop_token&) -> std::function<void()> {
            if (!scene.check())
                return [] {};
            return examine(*shared->prepared(scene));
        });
}

void PlaceJob::pick(const Scene& scene, QPointF place) {
    const vec2 pixels(dvec2(place.x(), place.y()) * dvec2(scene.film));
    examine(scene, [this, pixels](const PreparedScene& prepared) -> std::function<void()> {
        return [this, under = layersUnder(prepared, pixels)] { emit found(under); };
    });
}

void PlaceJob::look(const Scene& scene, const std::vector<dvec3>& placesMm) {
    examine(scene, [this, placesMm](const PreparedScene& prepared) -> std::function<void()> {
        std::vector<std::optional<HiddenBy>> hidden;
        hidden.reserve(placesMm.size());
        for (const dvec3& place : placesMm)
            hidden.push_back(hiddenBy(prepared, place));
        return [this, placesMm, hidden] { emit seen(placesMm, hidden); };
    });
}

void PlaceJob::drop() {
    cancel();
    scenes_.drop();
}

}  // namespace pdr::app
