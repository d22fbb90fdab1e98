#include "app/bench/live_image.h"

#include <utility>

#include "render/scene/scene.h"

namespace pdr::bench {

Result<LiveImage> startFilm(const Scene& scene, const std::string& device, int threads) {
    auto opened = openDevice(device, threads);
    if (!opened)
        return opened.error();
    auto film = startFilm(**opened, scene);
    if (!film)
        return film.error();
    return LiveImage{*std::move(opened), *std::move(film)};
}

}  // namespace pdr::bench
