#include "app/bench/scale/played_pool.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/tiles/lease_server.h"
#include "render/tiles/pool_state.h"
#include "render/tiles/shared_work.h"

namespace pdr::bench::scale {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::uint64_t kSeed = 1;

class Pool final : public LeaseServer, public SharedWork {
  public:
    explicit Pool(const std::shared_ptr<PoolState>& state) : LeaseServer(state), SharedWork(state) {}
};

/// Cost of a sample of tissue, in those of the background (render/tiles/cell_costs.h learns it).
constexpr double kTissueCost = 6;

/// Returns the middle of an image, of that part of its area.
Tile middleOf(ivec2 size, double part) {
    const ivec2 middle = glm::max(ivec2(glm::round(dvec2(size) * std::sqrt(part))), ivec2(1)), at = (size - middle) / 2;
    return {at.x, at.y, middle.x, middle.y};
}

/// Returns a result for that lease, of samples without light.
LeaseResult darkResult(const Lease& lease) {
    const std::size_t pixels = pixelCount(lease.tile);
    LeaseResult result{lease.number, lease.tile, lease.samples, std::vector<PixelSums>(pixels), {}, 0, {}};
    if (isDeep(lease.samples))
        result.moments.resize(pixels);
    return result;
}

struct Node {
    WorkerId id;
    std::deque<Lease> leases;
    double done = kNever;  ///< time at which the first lease is rendered
};

class Play {
  public:
    Play(ivec2 size, const PlayedNodes& nodes)
        : facts_(nodes),
          tissue_(middleOf(size, nodes.tissue)),
          state_(std::make_shared<PoolState>(kSeed, [this] { return now_; })),
          film_(size, 0) {
        state_->own.helps = false;
        state_->pinnedSplit = Split::tiles;
        auto scene = std::make_shared<Scene>();
        scene->film = size;
        scene_ = pool_.publish(Purpose::finalRender, std::move(scene));
        for (int i = 0; i < nodes.count; ++i) {
            const std::string name = std::to_string(i);
            nodes_.push_back({pool_.join(name, name), {}});
            pool_.hasScene(nodes_.back().id, scene_);
        }
    }

    PlayedResults results(std::uint64_t samples) {
        while (const std::uint64_t left = samples - film_.samplesPerPixel())
            order(std::min(left, nextOrder()));
        for (const Node& node : nodes_)
            results_.merged += double(pool_.status(node.id)->results);
        return results_;
    }

  private:
    /// Returns the samples of the next order, as an image for a file has them (BatchRender::wantedSamples()).
    std::uint64_t nextOrder() const {
        constexpr std::uint64_t kWhole = 1024;
        return std::max(kWhole, 3 * film_.samplesPerPixel());
    }

    void order(std::uint64_t samples) {
        const std::uint64_t next = film_.samplesPerPixel();
        pool_.begin(film_, scene_, {{film_.area(), next, next + samples}}, {});
        for (handOut(); !state_->request->isDone(); handOut())
            advance();
        pool_.end();
    }

    void handOut() {
        for (Node& node : nodes_) {
            while (std::optional<Lease> lease = pool_.take(node.id))
                node.leases.push_back(*std::move(lease));
            if (node.done == kNever && !node.leases.empty())
                node.done = now_ + secondsOf(node.leases.front());
        }
        if (ownDone_ == kNever && takeOwn())
            ownDone_ = now_ + secondsOf(*own_.lease);
    }

    /// Takes what the own device does, as SharedWork::nextOwn() has it, which would wait.
    bool takeOwn() {
        SharedRequest& request = *state_->request;
        own_ = {};
        state_->own.taken = now_;
        if (!state_->isAnyTaking())
            if (const auto portion =
                    request.scheduler().take(kOwnDevice, state_->abilityOf(state_->own.speed, true), now_))
                own_.lease = request.leaseOf(*portion);
        if (!own_.lease && (own_.audit = request.audits().takeLate(now_)))
            own_.lease = own_.audit->lease;
        return own_.lease.has_value();
    }

    /// Goes on to the next result.
    void advance() {
        Node& first = *std::ranges::min_element(nodes_, {}, &Node::done);
        if (first.done < ownDone_) {
            now_ = first.done;
            deliver(first);
        } else if (ownDone_ < kNever) {
            now_ = ownDone_;
            deliverOwn();
        } else {
            now_ += 0.001;  // a worker waits until a result is late
        }
    }

    void deliver(Node& node) {
        const Lease lease = std::move(node.leases.front());
        node.leases.pop_front();
        node.done = node.leases.empty() ? kNever : now_ + secondsOf(node.leases.front());
        results_.sent += 1;
        (isDeep(lease.samples) ? results_.deepPixels : results_.sumPixels) += pixelsOfTissue(lease.tile);
        LeaseResult result = darkResult(lease);
        result.seconds = secondsOf(lease);
        pool_.deliver(node.id, std::move(result));
    }

    void deliverOwn() {
        ownDone_ = kNever;
        LeaseResult result = darkResult(*own_.lease);
        result.seconds = secondsOf(*own_.lease);
        (void)(own_.audit ? pool_.audited(*own_.audit, std::move(result)) : pool_.deliverOwn(std::move(result)));
    }

    double pixelsOfTissue(const Tile& tile) const { return double(pixelCount(intersection(tile, tissue_))); }

    double secondsOf(const Lease& lease) const {
        const auto cost = [this](const Tile& tile) {
            return double(pixelCount(tile)) + (kTissueCost - 1) * pixelsOfTissue(tile);
        };
        const Tile image = film_.area();
        const double mean = cost(image) / double(pixelCount(image));
        return facts_.leaseSeconds + facts_.sampleSeconds * lease.samples.count * cost(lease.tile) / mean;
    }

    PlayedNodes facts_;
    Tile tissue_;  ///< pixels that show tissue
    double now_ = 0;
    std::shared_ptr<PoolState> state_;
    Pool pool_{state_};
    Film film_;
    std::uint64_t scene_ = 0;
    std::vector<Node> nodes_;
    SharedWork::OwnWork own_;
    double ownDone_ = kNever;
    PlayedResults results_;
};

}  // namespace

PlayedResults playedResults(ivec2 size, std::uint64_t samples, const PlayedNodes& nodes) {
    return Play(size, nodes).results(samples);
}

}  // namespace pdr::bench::scale
