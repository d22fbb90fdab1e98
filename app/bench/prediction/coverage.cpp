#include "app/bench/prediction/coverage.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "render/accuracy/forecast.h"

namespace pdr::bench {
namespace {

/// A picture in the making, shown whenever its samples have grown by a twelfth.
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
        const auto picture = film_->readback();
        if (!picture)
            return picture.error();
        return picture->status;
    }

  private:
    std::unique_ptr<Accumulator> film_;
    Display display_;
    std::uint64_t done_ = 0;
};

/// Goes on until the error is `part` of what it is now.
Result<void> judge(Growing& picture, const ErrorHistory& history, const FilmStatus& early, double part,
                   PredictionTally& tally) {
    const Foretold foretold = history.samples(part * early.displayError);
    Result<FilmStatus> status = early;
    while (status && status->displayError > part * early.displayError &&
           double(status->samplesPerPixel) < 2 * foretold.high)
        status = picture.next();
    if (!status)
        return status.error();
    const auto needed = double(status->samplesPerPixel);
    tally.atLeast += early.fewBrightSamples;
    tally.notBefore += needed >= foretold.low;
    tally.within += needed >= foretold.low && needed <= foretold.high;
    tally.ratios.push_back(foretold.value / needed);
    ++tally.seeds;
    return {};
}

}  // namespace

Result<PredictionTally> tallyOf(Scene scene, const Prediction& asked, int seeds, float exposure, Device& device) {
    PredictionTally tally;
    for (int seed = 1; seed <= seeds; ++seed) {
        scene.seed = std::uint64_t(seed);
        ++scene.revision;
        auto film = startFilm(device, scene);
        if (!film)
            return film.error();
        Growing picture(*std::move(film), exposure);
        ErrorHistory history;
        FilmStatus early;
        while (early.samplesPerPixel < asked.samples) {
            const auto next = picture.next();
            if (!next)
                return next.error();
            early = *next;
            history.add(double(early.samplesPerPixel), early);
        }
        if (const auto ok = judge(picture, history, early, asked.part, tally); !ok)
            return ok.error();
    }
    return tally;
}

}  // namespace pdr::bench
