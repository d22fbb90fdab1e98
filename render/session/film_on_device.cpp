#include "render/session/film_on_device.h"

#include <utility>

namespace pdr {

std::string spoken(const DeviceInfo& device) {
    return device.hostMemory ? "the CPU" : "the GPU " + device.name;
}

Result<void> FilmOnDevice::upload(Device& device) {
    return device.upload(flattener_.prepare(*scene_, boundsFor(device.info())));
}

Result<void> FilmOnDevice::begin(const Scene& scene, const Schedule& schedule) {
    film_.reset();
    scene_ = scene;
    schedule_ = schedule;
    if (Result<void> uploaded = upload(*device_); !uploaded)
        return uploaded;
    return restart(schedule);
}

Result<void> FilmOnDevice::restart(const Schedule& schedule) {
    film_.reset();
    schedule_ = schedule;
    Result<std::unique_ptr<LiveFilm>> film = device_->film(size(), revision(), schedule);
    if (!film)
        return film.error();
    film_ = *std::move(film);
    return {};
}

void FilmOnDevice::close() {
    forget();
    flattener_ = {};
    (void)device_->upload(nullptr);  // one that cannot even forget says so at the next scene
}

Result<void> FilmOnDevice::moveTo(std::unique_ptr<Device> device, const Film* from) {
    std::unique_ptr<LiveFilm> moved;
    if (scene_) {
        if (Result<void> uploaded = upload(*device); !uploaded)
            return uploaded;
        Result<std::unique_ptr<LiveFilm>> film = device->film(size(), revision(), schedule_);
        if (!film)
            return film.error();
        moved = *std::move(film);
        if (from != nullptr)
            if (Result<void> resumed = moved->resume(*from); !resumed)
                return resumed;
    }
    film_ = std::move(moved);
    device_ = std::move(device);
    info_ = device_->info();
    return {};
}

}  // namespace pdr
