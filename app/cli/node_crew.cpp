#include "app/cli/node_crew.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <random>
#include <set>
#include <thread>
#include <utility>

#include "render/tiles/reference_tiles.h"
#include "render/tiles/shared_device.h"

namespace pdr::app {
namespace {

void say(const QString& line) {
    std::fprintf(stderr, "%s\n", line.toUtf8().constData());
}

std::uint64_t seed() {
    std::random_device random;
    return std::uint64_t(random()) << 32 | random();
}

}  // namespace

NodeCrew::NodeCrew(const NodesWanted& wanted, const std::vector<std::byte>& bits)
    : wanted_(wanted), pool_(std::make_shared<WorkerPool>(seed())), nodes_(pool_, bits) {
    using nodes::NodeStatus;
    using nodes::RenderNodes;
    // This thread is busy: they speak for themselves.
    QObject::connect(
        &nodes_, &RenderNodes::joined, &nodes_,
        [](const NodeStatus& node) { say(QString("node %1 (%2) is there").arg(node.name, node.device)); },
        Qt::DirectConnection);
    QObject::connect(
        &nodes_, &RenderNodes::lost, &nodes_,
        [](const NodeStatus& node) { say(QString("node %1 is lost: %2").arg(node.name, node.reason)); },
        Qt::DirectConnection);
    pool_->setOwnHelps(!wanted.nodesOnly);
    if (wanted.split)
        pool_->setSplit(*wanted.split);
    nodes_.setBundle(wanted.bundle);
}

Result<std::unique_ptr<NodeCrew>> NodeCrew::gather(const NodesWanted& wanted, std::unique_ptr<Device>& device) {
    const Result<std::vector<std::byte>> bits = referenceTiles(*device);
    if (!bits)
        return bits.error();
    std::unique_ptr<NodeCrew> crew(new NodeCrew(wanted, *bits));
    for (const QString& address : wanted.nodes)
        if (const auto added = crew->nodes_.add(address); !added)
            return added.error();
    if (wanted.listen) {
        const auto address = crew->nodes_.listen(*wanted.listen);
        if (!address)
            return address.error();
        say("waiting for nodes at " + address->text());
    }
    device = shareDevice(std::move(device), crew->pool_);
    return crew;
}

bool NodeCrew::await(const std::stop_token& stop) const {
    std::set<WorkerId> told;
    for (;;) {
        const std::vector<WorkerStatus> workers = pool_->workers();
        for (const WorkerStatus& worker : workers)
            if (!worker.reason.empty() && told.insert(worker.id).second)
                say(QString("node %1 cannot help: %2").arg(worker.name.c_str(), worker.reason.c_str()));
        const auto ready = std::ranges::count_if(
            workers, [](const WorkerStatus& worker) { return worker.state == WorkerState::ready; });
        if (ready >= wanted_.await)
            return true;
        if (stop.stop_requested())
            return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
}

std::string NodeCrew::report() const {
    std::string text;
    const std::vector<WorkerStatus> workers = pool_->workers();
    double all = pool_->ownWork();
    for (const WorkerStatus& worker : workers)
        all += worker.work;
    for (const WorkerStatus& worker : workers) {
        char line[300];
        std::snprintf(line, sizeof line, "node %s: %.1f %% of the samples, %llu tiles, %llu checked%s%s\n",
                      worker.name.c_str(), all > 0 ? 100 * worker.work / all : 0,
                      static_cast<unsigned long long>(worker.results), static_cast<unsigned long long>(worker.audited),
                      worker.reason.empty() ? "" : "; ", worker.reason.c_str());
        text += line;
    }
    const SplitChoice split = pool_->split();
    if (!split.reason.empty())
        text += std::string("shared out by ") + (split.split == Split::tiles ? "tiles: " : "samples: ") + split.reason +
                "\n";
    return text;
}

}  // namespace pdr::app
