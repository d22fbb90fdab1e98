#pragma once
/// Films of small scenes as one device makes them, and as workers make them together. To be included first: it includes
/// TBB, of whose names Qt takes some for keywords.

#include "tests/support/scenes/tissue_scene.h"

#include <memory>
#include <vector>

#include "render/tiles/shared_device.h"
#include "render/tiles/worker_pool.h"

namespace pdr::test {

inline Scene sceneToShare() {
    Scene scene = tissueScene();
    scene.film = {90, 61};
    scene.revision = 7;
    return scene;
}

/// Whose paths end early, with light still on them.
inline Scene cutScene() {
    Scene scene = sceneToShare();
    scene.model = Model::multipleScattering;
    scene.maxBounces = 2;
    for (TransferNode& node : scene.transferFunction.nodes)
        node.albedo = vec3(1);
    return scene;
}

inline std::shared_ptr<WorkerPool> newPool() {
    return std::make_shared<WorkerPool>(1);
}

inline FilmContent alone(const Scene& scene, const std::vector<std::uint32_t>& orders) {
    const auto device = makeCpuDevice(1);
    const auto film = *startFilm(*device, scene);
    for (const std::uint32_t n : orders)
        (void)film->accumulate(n, {});
    return (*film->film())->content();
}

inline FilmContent shared(const Scene& scene, const std::vector<std::uint32_t>& orders,
                          std::shared_ptr<WorkerPool> pool) {
    const auto device = shareDevice(makeCpuDevice(1), std::move(pool));
    const auto film = *startFilm(*device, scene);
    for (const std::uint32_t n : orders)
        if (const auto done = film->accumulate(n, {}); !done)
            qFatal("%s", done.error().text().c_str());
    return (*film->film())->content();
}

/// The last one has several whole blocks, and a part of one before and behind them.
inline const std::vector<std::uint32_t> kOrders{1, 5, 40, 64, 30, 200};

/// What one device alone makes of sceneToShare() in kOrders, which it always makes the same.
inline const FilmContent& aloneInOrders() {
    static const FilmContent content = alone(sceneToShare(), kOrders);
    return content;
}

}  // namespace pdr::test
