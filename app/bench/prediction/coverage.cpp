#include "app/bench/prediction/coverage.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "render/accuracy/forecast.h"

namespace pdr::bench {
namespace {

/// An image in progress, whose status is read whenever its samples have grown by a twelfth.
class Growing {
  public:
    Growing(std::unique_ptr<Accumulator> film, float exposure) : film_(std::move(film)), display_{exposure} {}

    Result<FilmStatus> next() {
        const auto more = std::max<std::uint64_t>(done_ / 12, 8);
        if (const auto ok = film_->accumulate(std::uint32_t(more), {}); !ok)
            return ok.error();
        done_ += more;
        if (const auto ok = film_->resolve(display_); !ok)
            return ok.error();
        const auto image = film_->readback();
        if (!image)
            return image.error();
        return image->status;
    }

  private:
    std::unique_ptr<Accumulator> film_;
    Display display_;
    std::uint64_t done_ = 0;
};

/// A prediction of one image, followed until it is decided.
class Pending {
  public:
    Pending(const Prediction& asked, PredictionTally& tally) : asked_(asked), tally_(tally) {}

    bool isOpen() const { return !ended_; }
    /// Takes the current status of the image, which is in `history` too.
    void look(const FilmStatus& now, const ErrorHistory& history) {
        if (ended_ || now.samplesPerPixel < asked_.samples)
            return;
        if (target_ <= 0) {
            target_ = asked_.part * now.displayError;
            foretold_ = history.samples(target_);
            tally_.atLeast += std::isinf(foretold_.high);
        }
        const auto samples = double(now.samplesPerPixel);
        ended_ = now.displayError <= target_ || samples >= 2 * foretold_.high;
        if (ended_)
            count(samples);
    }

  private:
    void count(double needed) {
        tally_.notBefore += needed >= foretold_.low;
        tally_.within += needed >= foretold_.low && needed <= foretold_.high;
        tally_.ratios.push_back(foretold_.value / needed);
        ++tally_.seeds;
    }

    Prediction asked_;
    PredictionTally& tally_;
    double target_ = 0;  ///< target error [display levels]; 0: nothing was predicted yet
    Foretold foretold_;
    bool ended_ = false;
};

/// Renders one image until all its predictions are decided.
Result<void> judge(Growing image, std::vector<Pending> pending) {
    ErrorHistory history;
    while (std::ranges::any_of(pending, &Pending::isOpen)) {
        const auto status = image.next();
        if (!status)
            return status.error();
        history.add(double(status->samplesPerPixel), *status);
        for (Pending& each : pending)
            each.look(*status, history);
    }
    return {};
}

}  // namespace

Result<std::vector<PredictionTally>> talliesOf(Scene scene, std::span<const Prediction> asked, int seeds,
                                               float exposure, Device& device) {
    std::vector<PredictionTally> tallies(asked.size());
    for (int seed = 1; seed <= seeds; ++seed) {
        scene.seed = std::uint64_t(seed);
        ++scene.revision;
        auto film = startFilm(device, scene);
        if (!film)
            return film.error();
        std::vector<Pending> pending;
        for (std::size_t i = 0; i < asked.size(); ++i)
            pending.emplace_back(asked[i], tallies[i]);
        if (const auto ok = judge({*std::move(film), exposure}, std::move(pending)); !ok)
            return ok.error();
    }
    return tallies;
}

}  // namespace pdr::bench
