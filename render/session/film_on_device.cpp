#include "render/session/film_on_device.h"

#include <utility>

namespace pdr {

Text deviceLabel(const DeviceInfo& device) {
    return device.hostMemory ? phrase("the CPU") : phrase("the GPU %1", device.name);
}

Result<void> FilmOnDevice::begin(const Scene& scene, const Film* from) {
    torn_ = true;
    scene_ = scene;
    Result<void> begun = device_->upload(*scene_);
    if (!begun && film_) {  // the device may lack just the memory of the old film
        film_.reset();
        begun = device_->upload(*scene_);
    }
    if (!begun)
        return begun;
    begun = emptyFilm();
    if (begun && from != nullptr)
        begun = film_->resume(*from);
    if (!begun)
        film_.reset();
    torn_ = false;
    return begun;
}

Result<void> FilmOnDevice::emptyFilm() {
    if (film_ && scene_->schedule == schedule_)
        return film_->restart(wholeImage(size()), revision());
    film_.reset();
    schedule_ = scene_->schedule;
    Result<std::unique_ptr<Accumulator>> film = device_->film(size(), revision(), schedule_);
    if (!film)
        return film.error();
    film_ = *std::move(film);
    return {};
}

void FilmOnDevice::close() {
    forget();
    (void)device_->unload();  // a device that cannot even unload reports that at the next scene
}

Result<void> FilmOnDevice::moveTo(std::unique_ptr<Device> device, const Film* from) {
    std::unique_ptr<Accumulator> moved;
    if (scene_) {
        Result<std::unique_ptr<Accumulator>> film = startFilm(*device, *scene_);
        if (!film)
            return film.error();
        moved = *std::move(film);
        if (from != nullptr)
            if (Result<void> resumed = moved->resume(*from); !resumed)
                return resumed;
    }
    torn_ = false;
    film_ = std::move(moved);
    if (scene_)
        schedule_ = scene_->schedule;
    device_ = std::move(device);
    info_ = device_->info();
    return {};
}

}  // namespace pdr
