#include "app/tissue_study.h"

#include <functional>
#include <new>
#include <utility>

#include "render/prepare/flatten.h"

namespace pdr::app {

TissueStudy::TissueStudy() {
    worker_.moveToThread(&thread_);
}

TissueStudy::~TissueStudy() {
    ++volume_;
    thread_.quit();
    thread_.wait();
}

/// `work` runs on the thread; what it returns is called back here, unless the volume has changed. Where memory does not
/// suffice there is no answer, and all else goes on.
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

/// The thread holds the volume while it counts only: whoever opens another waits until this one is freed.
void TissueStudy::setVolume(const std::shared_ptr<const Volume>& volume) {
    ++volume_;
    if (!volume)
        return;
    start([this, weak = std::weak_ptr(volume)] {
        const auto held = weak.lock();
        auto histogram = std::make_shared<const Histogram>(held ? Histogram(*held) : Histogram());
        return [this, histogram] { emit histogramFound(histogram); };
    });
}

void TissueStudy::pick(const Scene& scene, QPointF place) {
    Scene without = scene;
    without.volume.reset();
    start([this, without, place, weak = std::weak_ptr(scene.volume)]() -> std::function<void()> {
        Scene full = without;
        full.volume = weak.lock();
        if (!full.volume || !full.check())
            return [] {};
        const ivec2 pixel(int(place.x() * full.film.x), int(place.y() * full.film.y));
        const std::optional<TissueUnder> tissue = tissueUnder(*Flattener().prepare(full), pixel);
        if (!tissue)
            return [this] { emit nothingFound(); };
        return [this, found = *tissue] { emit tissueFound(found); };
    });
}

}  // namespace pdr::app
