#pragma once
/// A pool of workers that make up their samples, one after the other and in no time, so that many images with liars
/// among them can be tried, and each trial can be repeated.

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "render/tiles/pool_state.h"
#include "render/tiles/worker_pool.h"

namespace pdr::test {

class MadeUpNodes : public LeaseServer, public SharedWork {
  public:
    /// What a node does.
    struct Nature {
        std::uint64_t liesOneIn = 0;      ///< it falsifies a pixel of every so many-th result of its own; 0: never
        std::uint64_t checksWrongly = 0;  ///< it falsifies every so many-th audit of others; 0: never
    };

    MadeUpNodes(std::uint64_t seed, const std::vector<Nature>& natures)
        : MadeUpNodes(std::make_shared<double>(0), seed) {
        for (const Nature& nature : natures) {
            const std::string key = "node " + std::to_string(nodes_.size());
            nodes_.push_back({join(key, key, false), nature});
        }
    }

    PoolState& state() { return *state_; }
    const Worker& worker(std::size_t node) { return *state_->registry.find(nodes_[node].id); }
    std::uint64_t liesOf(std::size_t node) const { return nodes_[node].lies; }
    /// Number of audits that the own device did.
    std::uint64_t ownAudits() const { return ownAudits_; }

    /// Renders `samples` of each pixel anew; the own device only audits, `ownAtATime` results in a round of all nodes.
    /// Returns whether a sample of the film is false.
    bool renders(Film& film, std::uint32_t samples, int ownAtATime = 1000) {
        film.restart(film.area(), 0);
        Scene scene;
        scene.film = {film.area().width, film.area().height};
        const std::uint64_t number = publish(Purpose::finalRender, std::make_shared<const Scene>(scene));
        for (const Node& node : nodes_)
            hasScene(node.id, number);
        if (!begin(film, number, {{film.area(), 0, samples}}, {}))
            qFatal("nobody else wants the nodes");
        SharedRequest& request = *state_->request;
        for (int idle = 0; !request.isDone(); ++idle) {
            if (idle > 1000)
                qFatal("an image is never finished");
            ++round_;  // another one begins each round, or one would do all audits
            for (std::size_t i = 0; i < nodes_.size(); ++i) {
                Node& node = nodes_[(i + round_) % nodes_.size()];
                if (const std::optional<Lease> lease = LeaseServer::take(node.id)) {
                    answer(node, *lease);
                    idle = 0;
                }
            }
            for (int i = 0; i < ownAtATime && auditOne(request); ++i)
                idle = 0;
        }
        (void)end();
        std::atomic<bool> isFalse = false;
        film.each([&](std::size_t, const Moments& known) {
            if (known.mean.x > 0)
                isFalse = true;
        });
        return isFalse;
    }

  private:
    struct Node {
        WorkerId id;
        Nature nature;
        std::uint64_t results = 0, audits = 0, lies = 0;
    };

    MadeUpNodes(const std::shared_ptr<double>& now, std::uint64_t seed)
        : MadeUpNodes(now, std::make_shared<PoolState>(seed, [now] { return *now; })) {}
    MadeUpNodes(std::shared_ptr<double> now, const std::shared_ptr<PoolState>& state)
        : LeaseServer(state), SharedWork(state), now_(std::move(now)), state_(state) {
        state_->own.helps = false;
        state_->pinnedSplit = Split::tiles;
    }

    /// Dark samples.
    static LeaseResult truthOf(const Lease& lease) {
        const auto count = std::uint32_t(lease.samples.end() - fromBlockStart(lease.samples).first);
        const auto pixels = std::size_t(lease.tile.width) * std::size_t(lease.tile.height);
        return {lease.number,
                lease.tile,
                lease.samples,
                std::vector<PixelSums>(pixels, PixelSums{.count = count}),
                {},
                0,
                {}};
    }

    void answer(Node& node, const Lease& lease) {
        LeaseResult result = truthOf(lease);
        const bool isOwn = state_->request->scheduler().heldBy(node.id, lease.number).has_value();
        const std::uint64_t count = isOwn ? ++node.results : ++node.audits;
        const std::uint64_t oneIn = isOwn ? node.nature.liesOneIn : node.nature.checksWrongly;
        if (oneIn > 0 && count % oneIn == 0) {
            result.sums[std::size_t(count * 7919) % result.sums.size()].sum.x = 1;
            ++node.lies;
        }
        result.seconds = 1e-5 * workOf(lease.tile, lease.samples);  // slow: a portion has a cell
        *now_ += result.seconds;
        deliver(node.id, std::move(result));
    }

    bool auditOne(SharedRequest& request) {
        const std::optional<Audit> audit =
            request.audits().takeIf([&](const Audit& one) { return !state_->mayAnyCheck(one); });
        if (!audit)
            return false;
        ++ownAudits_;
        if (const Result<void> done = audited(*audit, truthOf(audit->lease)); !done)
            qFatal("%s", done.error().text().c_str());
        return true;
    }

    std::shared_ptr<double> now_;
    std::shared_ptr<PoolState> state_;
    std::vector<Node> nodes_;
    std::uint64_t round_ = 0, ownAudits_ = 0;
};

}  // namespace pdr::test
