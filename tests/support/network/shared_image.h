#pragma once
/// Renders an image with the help of render nodes, and the same image without them.

#include "app/coordinator/render_nodes.h"
#include "render/tiles/reference_tiles.h"
#include "render/tiles/shared_device.h"
#include "render/tiles/worker_pool.h"
#include "tests/support/network/node_process.h"
#include "tests/support/scenes/tissue_scene.h"

namespace pdr::test {

/// A small scene whose cells at the right and lower edges are cut, and the requests that fill its film: a block in two
/// requests, and a whole block.
inline Scene sharedScene(std::uint64_t revision = 0) {
    Scene scene = tissueScene();
    scene.film = {122, 90};
    scene.revision = revision;
    return scene;
}
inline const std::vector<std::uint32_t> kSharedOrders{2, 62, 64};

/// Renders with nodes as a program does.
struct NodeTrial {
    std::shared_ptr<WorkerPool> pool = std::make_shared<WorkerPool>(1);
    nodes::RenderNodes nodes;
    std::unique_ptr<Device> device;

    NodeTrial() : nodes(pool, *referenceTiles(*makeCpuDevice(1))), device(shareDevice(makeCpuDevice(1), pool)) {}

    void add(const NodeProcess& node) {
        if (const auto added = nodes.add(node.address()); !added)
            qFatal("%s", added.error().text().c_str());
    }
    /// Waits until `count` nodes can render samples of the scene that is on the device.
    void awaitReady(int count) const {
        const auto ready = [&] {
            return std::ranges::count_if(pool->workers(),
                                         [](const WorkerStatus& worker) { return worker.state == WorkerState::ready; });
        };
        while (ready() < count)
            QThread::msleep(2);
    }
    FilmContent image(const Scene& scene, const std::vector<std::uint32_t>& orders, int await = 0) const {
        const auto film = *startFilm(*device, scene);
        awaitReady(await);
        for (const std::uint32_t n : orders)
            if (const auto done = film->accumulate(n, {}); !done)
                qFatal("%s", done.error().text().c_str());
        return (*film->film())->content();
    }
    double workOfNodes() const {
        double work = 0;
        for (const WorkerStatus& worker : pool->workers())
            work += worker.work;
        return work;
    }
};

inline FilmContent imageAlone(const Scene& scene, const std::vector<std::uint32_t>& orders) {
    const auto device = makeCpuDevice();
    const auto film = *startFilm(*device, scene);
    for (const std::uint32_t n : orders)
        (void)film->accumulate(n, {});
    return (*film->film())->content();
}

}  // namespace pdr::test
