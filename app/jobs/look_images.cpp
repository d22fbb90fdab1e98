#include "app/jobs/look_images.h"

#include <QElapsedTimer>
#include <algorithm>
#include <iterator>

#include "app/looks/looks.h"
#include "app/looks/small_image.h"
#include "render/device/device.h"
#include "render/film/display/tone_map.h"
#include "render/volume/coarser.h"

namespace pdr::app {
namespace {

constexpr qint64 kRestMs = 600;      ///< pause before images are made anew [ms]
constexpr qint64 kRestsPerWork = 2;  ///< pause after each of them, in multiples of its time

/// Waits `ms` milliseconds. Returns false if it was stopped.
bool waitFor(qint64 ms, const std::stop_token& stop) {
    for (; ms > 0 && !stop.stop_requested(); ms -= 10)
        QThread::msleep(10);
    return !stop.stop_requested();
}

/// Waits until `stands` is true. Returns false if it was stopped.
bool waitUntil(const std::atomic<bool>& stands, const std::stop_token& stop) {
    while (!stands && waitFor(10, stop)) {
    }
    return !stop.stop_requested();
}

Progress goOnUnless(const std::stop_token& stop) {
    return [stop](double, std::string_view) { return !stop.stop_requested(); };
}

struct LookImage {
    QImage image;
    double stops = 0;
};

/// `scene`: that of the task, of coarse voxels.
Result<LookImage> imageOf(const LookTask& task, Scene scene, const VolumeGeometry& body, Device& device,
                          const std::stop_token& stop) {
    ImageSetup setup = task.setup;
    scene.revision = std::uint64_t(task.look) + 1;
    const auto small = smallImage(scene, body, double(displayOf(setup).exposure), device, stop);
    if (!small)
        return small.error();
    if (followsTissue(scene.model))
        setup.stops = small->stops;
    Display display = displayOf(setup);
    display.denoised = canBeDenoised(scene);
    const Image rendered = pdr::imageOf(*small->film, display, stop);
    const QImage bytes(rendered.rgba.data(), kSmallImagePixels, kSmallImagePixels, QImage::Format_RGBX8888);
    return LookImage{bytes.copy(), setup.stops};
}

}  // namespace

const std::shared_ptr<const Mask>& LookImages::Coarse::maskOf(const Visible& visible, const segment::BodyParts& parts,
                                                              const std::stop_token& stop) {
    for (const auto& [known, mask] : masks)
        if (known == visible)
            return mask;
    return masks.emplace_back(visible, coarseMask(*volume, parts, visible, goOnUnless(stop))).second;
}

std::shared_ptr<const LabelMap> LookImages::Coarse::partsOf(const std::shared_ptr<const LabelMap>& fine) {
    if (!fine)
        return nullptr;
    if (fineParts.lock() != fine)
        parts = std::make_shared<const LabelMap>(coarser(*fine, volume->geometry()));
    fineParts = fine;
    return parts;
}

void LookImages::make(const std::shared_ptr<const Volume>& volume,
                      const std::shared_ptr<const segment::BodyParts>& parts, const VolumeGeometry& body,
                      const std::vector<LookTask>& tasks) {
    // Skip tasks that are running or done
    const bool first = volume_.lock() != volume;
    if (!first && std::ranges::is_permutation(tasks, tasks_))
        return;
    if (first)
        forgetImages();
    volume_ = volume;
    tasks_ = tasks;
    std::vector<LookTask> missing;
    std::ranges::copy_if(tasks, std::back_inserter(missing),
                         [this](const LookTask& task) { return std::ranges::find(made_, task) == made_.end(); });
    // Make the coarse copy, then one image after the other
    start([this, first, volume, parts, coarse = coarse_, body, missing, imageStands = imageStands_](
              const Progress&, const std::stop_token& stop) mutable -> std::function<void()> {
        if (!first && !waitFor(kRestMs, stop))
            return [] {};
        if (!coarse.volume)
            coarse.volume = coarseCopy(*volume);
        const std::unique_ptr<Device> device = makeCpuDevice(1);
        for (const LookTask& task : missing) {
            QElapsedTimer clock;
            clock.start();
            Scene scene = sceneOf(task.setup, coarse.volume, ivec2(kSmallImagePixels), coarse.partsOf(task.parts));
            scene.mask = coarse.maskOf(task.setup.look.visible, *parts, stop);
            const auto rendered = imageOf(task, std::move(scene), body, *device, stop);
            if (stop.stop_requested())
                return [] {};
            if (rendered)
                QMetaObject::invokeMethod(this, [this, stop, coarse, task, rendered = *rendered] {
                    if (stop.stop_requested())
                        return;
                    coarse_ = coarse;
                    std::erase_if(made_, [&](const LookTask& before) { return before.look == task.look; });
                    made_.push_back(task);
                    emit made(task.look, rendered.image, rendered.stops);
                });
            if (!(first ? waitUntil(*imageStands, stop) : waitFor(kRestsPerWork * clock.elapsed(), stop)))
                return [] {};
        }
        parts->forgetDistances();
        return [] {};
    });
}

void LookImages::forget() {
    cancel();
    volume_.reset();
    tasks_.clear();
    forgetImages();
}

void LookImages::forgetImages() {
    made_.clear();
    coarse_ = {};
}

}  // namespace pdr::app
