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

void TissueStudy::setVolume(const std::shared_ptr<const Volume>& volume) {
    ++volume_;
    if (!volume)
        return;
    start([this, volume] {
        const auto histogram = std::make_shared<const Histogram>(*volume);
        return [this, histogram] { emit histogramFound(histogram); };
    });
}

void TissueStudy::pick(const Scene& scene, QPointF place) {
    start([this, scene, place]() -> std::function<void()> {
        if (!scene.check())
            return [] {};
        const ivec2 pixel(int(place.x() * scene.film.x), int(place.y() * scene.film.y));
        const std::optional<TissueUnder> tissue = tissueUnder(*Flattener().prepare(scene), pixel);
        if (!tissue)
            return [this] { emit nothingFound(); };
        return [this, found = *tissue] { emit tissueFound(found); };
    });
}

}  // namespace pdr::app
