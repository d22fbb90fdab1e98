#include "app/look_pictures.h"

#include <QElapsedTimer>
#include <algorithm>

#include "app/looks.h"
#include "render/device/device.h"
#include "render/film/exposure.h"
#include "render/film/tone_map.h"
#include "render/scene/fit_view.h"
#include "render/scene/visible_mask.h"
#include "render/volume/coarser.h"

namespace pdr::app {
namespace {

constexpr double kEdgeMm = 2.5;         ///< of the coarse voxels: a pixel shows 2 to 5 mm
constexpr std::uint32_t kSamples = 16;  ///< of each pixel
constexpr double kFilled = 0.94;        ///< of the picture
constexpr qint64 kRestMs = 600;         ///< before pictures are made anew
constexpr qint64 kRestsPerWork = 2;     ///< while they are

/// Returns false if it was stopped.
bool waitFor(qint64 ms, const std::stop_token& stop) {
    for (; ms > 0 && !stop.stop_requested(); ms -= 10)
        QThread::msleep(10);
    return !stop.stop_requested();
}

/// Returns false if it was stopped.
bool waitUntil(const std::atomic<bool>& stands, const std::stop_token& stop) {
    while (!stands && waitFor(10, stop)) {}
    return !stop.stop_requested();
}

Progress goOnUnless(const std::stop_token& stop) {
    return [stop](double, std::string_view) { return !stop.stop_requested(); };
}

/// Told apart in the whole scan, since thin bone is lost in coarse voxels. Null: all is shown, as it is in the large
/// picture where the parts cannot be told apart.
std::shared_ptr<const Mask> maskFor(const Volume& coarse, const segment::BodyParts& parts, const Visible& visible,
                                    const std::stop_token& stop) {
    const auto mask = visibleMask(parts, visible, coarse.geometry(), goOnUnless(stop));
    return mask ? *mask : nullptr;
}

struct LookPicture {
    QImage image;
    double stops = 0;
};

Result<LookPicture> pictureOf(const LookTask& task, const std::shared_ptr<const Volume>& volume,
                              const std::shared_ptr<const Mask>& mask, const VolumeGeometry& body, Device& device,
                              const std::stop_token& stop) {
    PictureSetup setup = task.setup;
    setup.camera = fittedView(setup.camera, body, 1, kFilled);
    Scene scene = sceneOf(setup, volume, ivec2(LookPictures::kSize));
    scene.mask = mask;
    scene.revision = std::uint64_t(task.look) + 1;
    const auto film = startFilm(device, scene);
    if (!film)
        return film.error();
    if (auto ok = (*film)->accumulate(kSamples, stop); !ok)
        return ok.error();
    const auto known = (*film)->film();
    if (!known || stop.stop_requested())
        return known ? Error{"", "", ""} : known.error();
    if (followsTissue(scene.model))
        setup.stops = stopsFor(**known, double(displayOf(setup).exposure));
    Display display = displayOf(setup);
    display.smoothed = canBeSmoothed(scene);
    const Picture picture = pdr::pictureOf(**known, display, stop);
    const QImage bytes(picture.rgba.data(), LookPictures::kSize, LookPictures::kSize, QImage::Format_RGBX8888);
    return LookPicture{bytes.copy(), setup.stops};
}

}  // namespace

const std::shared_ptr<const Mask>& LookPictures::Coarse::maskOf(const Visible& visible, const segment::BodyParts& parts,
                                                                const std::stop_token& stop) {
    for (const auto& [known, mask] : masks)
        if (known == visible)
            return mask;
    return masks.emplace_back(visible, visible.all() ? nullptr : maskFor(*volume, parts, visible, stop)).second;
}

void LookPictures::make(const std::shared_ptr<const Volume>& volume,
                        const std::shared_ptr<const segment::BodyParts>& parts, const VolumeGeometry& body,
                        const std::vector<LookTask>& tasks) {
    const bool first = volume_.lock() != volume;
    if (!first && std::ranges::is_permutation(tasks, tasks_))
        return;
    if (first)
        coarse_ = {};
    volume_ = volume;
    tasks_ = tasks;
    start([this, first, volume, parts, coarse = coarse_, body, tasks](
              const Progress&, const std::stop_token& stop) mutable -> std::function<void()> {
        if (!first && !waitFor(kRestMs, stop))
            return [] {};
        if (!coarse.volume)
            coarse.volume = std::make_shared<const Volume>(coarser(*volume, kEdgeMm));
        const std::unique_ptr<Device> device = makeCpuDevice(1);
        for (const LookTask& task : tasks) {
            QElapsedTimer clock;
            clock.start();
            const auto& mask = coarse.maskOf(task.setup.look.visible, *parts, stop);
            const auto picture = pictureOf(task, coarse.volume, mask, body, *device, stop);
            if (stop.stop_requested())
                return [] {};
            if (picture)
                QMetaObject::invokeMethod(this, [this, stop, coarse, look = task.look, picture = *picture] {
                    if (stop.stop_requested())
                        return;
                    coarse_ = coarse;
                    emit made(look, picture.image, picture.stops);
                });
            if (!(first ? waitUntil(imageStands_, stop) : waitFor(kRestsPerWork * clock.elapsed(), stop)))
                return [] {};
        }
        return [] {};
    });
}

void LookPictures::forget() {
    cancel();
    volume_.reset();
    tasks_.clear();
    coarse_ = {};
}

}  // namespace pdr::app
