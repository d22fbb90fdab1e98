#include "render/session/film_on_device.h"

#include <utility>

namespace pdr {

Text deviceLabel(const DeviceInfo& device) {
    return device.hostMemory ? phrase("the CPU") : phrase("the GPU %1", device.name);
}

Result<void> FilmOnDevice::begin(const Scene& scene) {
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
    if (!begun)
        film_.reset();
    torn_ = false;
    return begun;
}

Result<void> FilmOnDevice::begin(const Scene& scene, const AttestedFilm& from) {
    if (Result<void> begun = begin(scene); !begun)
        return begun;
    Result<void> resumed = film_->resume(*from.film);
    if (resumed)
        film_->credit(from.contributors);
    else
        film_.reset();
    return resumed;
}

Result<AttestedFilm> FilmOnDevice::putAway() {
    torn_ = true;
    Contributors contributors = film_->contributors();
    Result<std::shared_ptr<const Film>> film = film_->putAway();
    if (!film)
        return film.error();
    return AttestedFilm{*std::move(film), std::move(contributors)};
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
        if (from != nullptr) {
            if (Result<void> resumed = moved->resume(*from); !resumed)
                return resumed;
            if (film_)
                moved->credit(film_->contributors());
        }
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
