#include "app/cli/nodes/command_nodes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <utility>

#include "app/coordinator/new_pool.h"
#include "render/scene/scene.h"
#include "render/tiles/reference_tiles.h"
#include "render/tiles/shared_device.h"

namespace pdr::app {
namespace {

void say(const QString& line) {
    std::fprintf(stderr, "%s\n", line.toUtf8().constData());
}

/// Voxels per sample of an image from which on a node is no help: by the time that it has them, half of the image is
/// there.
constexpr double kVoxelsPerSample = 8;

/// Whether nodes can shorten an image of so many samples per pixel, which they begin when they have its voxels.
bool isWorthSending(const Scene& scene, std::uint64_t samples) {
    return double(scene.film.x) * scene.film.y * double(samples) * kVoxelsPerSample >=
           double(scene.volume->geometry().voxelCount());
}

}  // namespace

CommandNodes::CommandNodes(const NodesWanted& wanted, const std::vector<std::byte>& bits)
    : wanted_(wanted), pool_(nodes::newPool()), nodes_(pool_, bits) {
    listenToNews();
    pool_->setOwnHelps(!wanted.nodesOnly);
    pool_->setChecksAll(wanted.checksAll);
    if (wanted.split)
        pool_->setSplit(*wanted.split);
    nodes_.setBundle(wanted.bundle);
}

/// Handles the signals directly in the network thread, because this thread is busy rendering.
void CommandNodes::listenToNews() {
    using nodes::NodeStatus;
    using nodes::RenderNodes;
    const auto on = [this](auto signal, auto&& hear) {
        QObject::connect(&nodes_, signal, &nodes_, std::forward<decltype(hear)>(hear), Qt::DirectConnection);
    };
    on(&RenderNodes::joined,
       [](const NodeStatus& node) { say(QString("node %1 (%2) is there").arg(node.name, node.device)); });
    on(&RenderNodes::lost, [this](const NodeStatus& node) {
        const std::lock_guard lock(mutex_);
        say(news_.gone(node));
    });
    on(&RenderNodes::seen, [this](const std::vector<NodeStatus>& nodes) { sayNewsOf(nodes); });
    on(&RenderNodes::turnedAway, [this](const QString& peer, const QString& reason) {
        const std::lock_guard lock(mutex_);
        if (const QString line = news_.turnedAway(peer, reason); !line.isEmpty())
            say(line);
    });
}

void CommandNodes::sayNewsOf(const std::vector<nodes::NodeStatus>& nodes) {
    const std::lock_guard lock(mutex_);
    for (const QString& line : news_.follow(nodes))
        say(line);
}

int CommandNodes::helpless() const {
    const std::lock_guard lock(mutex_);
    return news_.helpless();
}

Result<std::unique_ptr<CommandNodes>> CommandNodes::gather(const NodesWanted& wanted, Device& device) {
    const Result<std::vector<std::byte>> bits = referenceTiles(device);
    if (!bits)
        return bits.error();
    std::unique_ptr<CommandNodes> crew(new CommandNodes(wanted, *bits));
    for (const QString& address : wanted.nodes)
        if (const auto added = crew->nodes_.add(address); !added)
            return added.error();
    if (wanted.listen) {
        const auto address = crew->nodes_.listen(*wanted.listen);
        if (!address)
            return address.error();
        say("waiting for nodes at " + address->text());
    }
    return crew;
}

std::unique_ptr<Device> CommandNodes::share(std::unique_ptr<Device> device, const Scene& scene,
                                            std::optional<std::uint64_t> samples) {
    isShared_ = !samples || wanted_.nodesOnly || isWorthSending(scene, *samples);
    if (isShared_)
        return shareDevice(std::move(device), pool_);
    say("this machine renders alone: with so few samples the image is there before a node would have the scan");
    return device;
}

Result<void> CommandNodes::await(const std::stop_token& stop) const {
    if (!isShared_)
        return {};
    const auto start = std::chrono::steady_clock::now();
    const auto tooFew = [&](const std::string& count, const std::string& when) {
        return Error{count + " of " + std::to_string(wanted_.await) + " render nodes " + when, "--await",
                     "What keeps the others away is said above. Nothing was written."};
    };
    for (;;) {
        const auto ready = std::ranges::count_if(
            pool_->workers(), [](const WorkerStatus& worker) { return worker.state == WorkerState::ready; });
        if (ready >= wanted_.await)
            return {};
        if (stop.stop_requested())
            return Error{"ended before the nodes were there: nothing was written", "", ""};
        const int possible = int(wanted_.nodes.size()) - helpless();
        if (!wanted_.listen && possible < wanted_.await)
            return tooFew("only " + std::to_string(possible), "can still come");
        if (std::chrono::steady_clock::now() - start >= std::chrono::seconds(wanted_.awaitSeconds))
            return tooFew(std::to_string(ready), "are ready after " + std::to_string(wanted_.awaitSeconds) + " s");
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

std::string CommandNodes::report() {
    sayNewsOf(nodes_.look());
    std::string text;
    const std::lock_guard lock(mutex_);
    for (const QString& line : news_.report(pool_->workers(), pool_->ownWork()))
        text += line.toStdString() + '\n';
    const SplitChoice split = pool_->split();
    if (!split.reason.empty())
        text += std::string("shared out by ") + (split.split == Split::tiles ? "tiles: " : "samples: ") + split.reason +
                "\n";
    return text;
}

}  // namespace pdr::app
