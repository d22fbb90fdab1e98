#include "app/jobs/tissue_study.h"

#include <functional>
#include <new>
#include <utility>

#include "render/prepare/flatten.h"
#include "render/prepare/layers_text.h"

namespace pdr::app {

TissueStudy::TissueStudy() {
    worker_.moveToThread(&thread_);
}

TissueStudy::~TissueStudy() {
    ++volume_;
    thread_.quit();
    thread_.wait();
}

/// Runs `work` on the thread. The function that it returns is called on the caller's thread, unless the volume has
/// changed. If memory does not suffice there is no answer, and everything else goes on.
template <class Work>
void TissueStudy::start(Work work) {
    thread_.start();
    QMetaObject::invokeMethod(&worker_, [this, volume = volume_.load(), work = std::move(work)]() mutable {
        if (volume != volume_)
            return;
        try {
            auto result = work();
            QMetaObject::invokeMethod(this, [this, volume, result = std::move(result)] {
                if (volume == volume_)
                    result();
            });
        } catch (const std::bad_alloc&) {
        }
    });
}

void TissueStudy::setVolume(const std::shared_ptr<const Volume>& volume) {
    ++volume_;
    if (!volume)
        return;
    start([this, volume] {
        const auto histogram = std::make_shared<const Histogram>(*volume);
        return [this, histogram] { emit histogramFound(histogram); };
    });
}

/// Calls `find` with the prepared scene and what is seen at `place`, and `tell` with the result.
template <class Find, class Tell>
void TissueStudy::look(const Scene& scene, QPointF place, Find find, Tell tell) {
    start([this, scene, place, find, tell]() -> std::function<void()> {
        if (!scene.check())
            return [] {};
        const auto prepared = Flattener().prepare(scene);
        const LayersUnder under = layersUnder(*prepared, vec2(dvec2(place.x(), place.y()) * dvec2(scene.film)));
        const Text text = layersText(under);
        if (under.layers.empty())
            return [this, text] { emit nothingFound(text); };
        return [this, text, tell, found = find(*prepared, under)] {
            tell(found);
            if (!text.empty())
                emit layerTaken(text);
        };
    });
}

void TissueStudy::pick(const Scene& scene, QPointF place) {
    const auto tissue = [](const PreparedScene& prepared, const LayersUnder& under) {
        return tissueBehind(prepared, under.heaviest()->placeMm, under.direction);
    };
    look(scene, place, tissue, [this](const TissueBehind& found) { emit tissueFound(found); });
}

void TissueStudy::measureDepth(const Scene& scene, QPointF place) {
    const auto depth = [](const PreparedScene&, const LayersUnder& under) { return under.heaviest()->depthMm; };
    look(scene, place, depth, [this](double depthMm) { emit depthFound(depthMm); });
}

}  // namespace pdr::app
