#pragma once
/// The picture in the making together with the device that makes it, so that both can be changed for others.

#include <memory>
#include <optional>
#include <string>

#include "render/device/device.h"
#include "render/scene/scene.h"

namespace pdr {

/// A device in a sentence: "the CPU", "the GPU cuda:1".
Text deviceLabel(const DeviceInfo& device);

class FilmOnDevice {
  public:
    explicit FilmOnDevice(std::unique_ptr<Device> device) : device_(std::move(device)), info_(device_->info()) {}

    const DeviceInfo& info() const { return info_; }
    /// Null: nothing is being rendered.
    Accumulator* film() const { return torn_ ? nullptr : film_.get(); }
    bool hasScene() const { return scene_.has_value(); }
    // Of the scene:
    ivec2 size() const { return scene_->film; }
    std::uint64_t revision() const { return scene_->revision; }

    /// Of the film; see Device::guide().
    std::shared_ptr<const denoise::Guide> guide(int finer, const std::stop_token& stop) {
        return device_->guide(finer, stop);
    }
    /// An empty film of `scene`. Errors: the device's; there is no film then.
    Result<void> begin(const Scene& scene);
    /// Goes on on `device`, from `from` where that is not null. Errors: the new device's; everything is as before then.
    Result<void> moveTo(std::unique_ptr<Device> device, const Film* from);
    /// Lends the device to `work`, which may give it other scenes; then it holds that of the film again. Errors: those
    /// of the device, whose film is lost then.
    template <class Work>
    Result<void> lend(const Work& work) {
        const Result<void> done = work(*device_);
        const Result<void> back = device_->upload(*scene_);
        return done ? back : done;
    }
    /// The film is worthless after a stop; its memory is kept for the next one.
    void tearFilm() { torn_ = true; }
    /// The same, and its memory is given back.
    void dropFilm() { film_.reset(); }
    /// As if there had been no scene.
    void forget() {
        film_.reset();
        scene_.reset();
    }
    /// The same, and nothing is kept for the next one either: neither here nor on the device.
    void close();

  private:
    /// An empty film of the scene, in the memory of the last one where that is of the same schedule.
    Result<void> emptyFilm();

    std::unique_ptr<Device> device_;
    DeviceInfo info_;
    std::optional<Scene> scene_;
    Schedule schedule_;  ///< of the film
    bool torn_ = false;
    std::unique_ptr<Accumulator> film_;  ///< after device_: it must not outlive it
};

}  // namespace pdr
