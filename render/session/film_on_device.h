#pragma once
/// The film in progress together with the device that renders it, so that both can be replaced.

#include <memory>
#include <optional>
#include <string>

#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr {

/// Returns the device's name as used in a sentence: "the CPU", "the GPU cuda:1".
Text deviceLabel(const DeviceInfo& device);

/// A film apart from its device, and who has contributed to it.
struct AttestedFilm {
    std::shared_ptr<const Film> film;  ///< never null
    Contributors contributors;
};

class FilmOnDevice {
  public:
    explicit FilmOnDevice(std::unique_ptr<Device> device) : device_(std::move(device)), info_(device_->info()) {}

    const DeviceInfo& info() const { return info_; }
    /// Returns the film; null if nothing is being rendered.
    Accumulator* film() const { return torn_ ? nullptr : film_.get(); }
    bool hasScene() const { return scene_.has_value(); }
    // Properties of the scene, which must exist:
    ivec2 size() const { return scene_->film; }
    std::uint64_t revision() const { return scene_->revision; }

    /// Makes a guide for the film; see Device::guide().
    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) {
        return device_->guide(rays, stop);
    }
    /// Begins an empty film of `scene`. Errors: the device's; there is no film then.
    Result<void> begin(const Scene& scene);
    /// Begins a film of `scene` with the samples of `from`. Errors: as above.
    Result<void> begin(const Scene& scene, const AttestedFilm& from);
    /// Returns the film, which must exist, and is without one from now on. Errors: the device's.
    Result<AttestedFilm> putAway();
    /// Returns whether the device still trusts those who took the film.
    bool trusts(const AttestedFilm& film) const { return device_->trusts(film.contributors); }
    /// Continues on `device`, from `from` unless that is null. Errors: the new device's; nothing changes then.
    Result<void> moveTo(std::unique_ptr<Device> device, const Film* from);
    /// Lends the device to `work`, which may upload other scenes; afterwards uploads that of the film again. Errors:
    /// the device's; its film is lost then.
    template <class Work>
    Result<void> lend(const Work& work) {
        const Result<void> done = work(*device_);
        const Result<void> back = device_->upload(*scene_);
        return done ? back : done;
    }
    /// Marks the film as worthless, after a stop; its memory is kept for the next one.
    void tearFilm() { torn_ = true; }
    /// Drops the film and frees its memory.
    void dropFilm() { film_.reset(); }
    /// Forgets the scene and drops the film.
    void forget() {
        film_.reset();
        scene_.reset();
    }
    /// Forgets the scene and drops the film, and also frees what the device keeps for the next scene.
    void close();

  private:
    /// Makes an empty film of the scene, in the memory of the previous one if that has the same schedule.
    Result<void> emptyFilm();

    std::unique_ptr<Device> device_;
    DeviceInfo info_;
    std::optional<Scene> scene_;
    Schedule schedule_;  ///< schedule of the film
    bool torn_ = false;
    std::unique_ptr<Accumulator> film_;  ///< declared after device_, which must outlive it
};

}  // namespace pdr
