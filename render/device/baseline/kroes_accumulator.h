#pragma once
/// A film that is rendered by the schedule of Exposure Render (Kroes, Post & Botha 2012), which `pd` replaces. Each
/// iteration runs these stages one after the other, and the host waits after each:
///   [K0] all parameters sent again -> one sample of every pixel -> [filter along x -> along y] -> mean -> tone map ->
///   copy to pageable memory
/// A resolve() after one iteration is the old frame; n iterations make n copies, of which the last is shown. The filter
/// on the 8-bit image that Exposure Render runs for its first 86 iterations is left out, in its favour.
///
/// With Schedule::runningMean the error is unknown: status() then has an infinite relative error and no mean luminance
/// (0), and film() infinite standard errors. Without it, resolve() copies the sums to the host to compute them; timings
/// should not include that.

#include <cassert>
#include <deque>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "render/device/accumulator.h"
#include "render/device/baseline/kroes_resend.h"
#include "render/scene/schedule.h"

namespace pdr {

template <Gpu G>
class KroesAccumulator final : public Accumulator {
  public:
    /// Makes an empty film of that area; `gpu` must outlive it. Errors: not enough memory.
    static Result<std::unique_ptr<Accumulator>> make(G& gpu, const Tile& area, std::uint64_t revision,
                                                     const Schedule& schedule, std::unique_ptr<FrameSampler> sampler) {
        std::unique_ptr<Accumulator> film(new KroesAccumulator(gpu, schedule, std::move(sampler)));
        if (Result<void> room = film->restart(area, revision); !room)
            return room.error();
        return Result<std::unique_ptr<Accumulator>>(std::move(film));  // nvcc needs the explicit type
    }

    using Accumulator::accumulate;
    using Accumulator::resolve;

    Tile area() const override { return area_; }

    Result<void> restart(const Tile& area, std::uint64_t revision) override {
        area_ = area;
        revision_ = revision;
        done_ = 0;
        health_ = {};
        stale_ = true;
        images_.clear();
        rgba_.resize(4 * pixels());
        frame_.resize(pixels());
        rgbaOnDevice_.resize(4 * pixels());
        if (schedule_.filter)
            blurred_.resize(pixels());
        if (schedule_.runningMean) {
            mean_.resize(pixels());
            mean_.clear();
        } else {
            moments_.resize(pixels());
            block_.resize(pixels());
            moments_.clear();
            block_.clear();
        }
        sampler_->restart(area);
        gpu_.awaitAll();
        if (std::optional<Error> error = gpu_.takeError())
            return *std::move(error);
        return {};
    }

    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override {
        if (!(region == area_))
            return Error{phrase("Exposure Render's schedule takes whole images only"), "",
                         phrase("Choose the schedule of PD-Render."), ErrorKind::refused};
        for (; n > 0 && !stop.stop_requested(); --n)
            if (Result<void> done = iterateOnce(stop); !done)
                return done;
        return {};
    }

    /// Requests an image that is never denoised, since it serves for comparison.
    Result<void> resolve(const Display& display, std::stop_token) override {
        if (stale_ || display.exposure != display_.exposure) {
            display_ = {display.exposure};
            stale_ = true;
            toneMap();
            if (std::optional<Error> error = gpu_.takeError())
                return *std::move(error);
            stale_ = false;
        }
        Result<FilmStatus> known = status();
        if (!known)
            return known.error();
        images_.push_back({rgba_, *known});
        return {};
    }

    Result<Image> readback() override {
        assert(!images_.empty());
        Image oldest = std::move(images_.front());
        images_.pop_front();
        return oldest;
    }

    int maxInFlight() const override { return 1; }

    Result<std::shared_ptr<const Film>> film() override {
        const Result<Health> health = allHealth();
        if (!health)
            return health.error();
        TileProgress progress(area_);
        progress.advance(area_, done_);
        FilmContent content{std::move(progress), std::vector<Moments>(pixels()), std::vector<PixelSums>(pixels()),
                            *health};
        if (schedule_.runningMean) {
            std::vector<SampledPixel> mean(pixels());
            mean_.copyTo(mean.data());
            for (std::size_t i = 0; i < pixels(); ++i) {
                content.moments[i] = momentsOf(mean[i]);
                content.block[i].seen = mean[i].seen;
            }
        } else {
            moments_.copyTo(content.moments.data());
            block_.copyTo(content.block.data());
        }
        if (std::optional<Error> error = gpu_.takeError())
            return *std::move(error);
        return std::make_shared<const Film>(revision_, std::move(content));
    }

    Result<void> resume(const Film& film) override {
        assert(film.area() == area_);
        const FilmContent content = film.content();
        if (schedule_.runningMean) {
            std::vector<SampledPixel> mean(pixels());
            for (std::size_t i = 0; i < pixels(); ++i) {
                const Moments known = merged(content.moments[i], content.block[i]);
                mean[i] = {vec3(known.mean), std::uint16_t(known.count > 0), std::uint16_t(content.block[i].seen)};
            }
            mean_.copyFrom(mean.data());
        } else {
            moments_.copyFrom(content.moments.data());
            block_.copyFrom(content.block.data());
        }
        if (std::optional<Error> error = gpu_.takeError())
            return *std::move(error);
        if (const Result<Health> dropped = sampler_->takeHealth(); !dropped)
            return dropped.error();
        done_ = content.progress.counts().least;
        health_ = content.health;
        stale_ = true;
        return {};
    }

  private:
    KroesAccumulator(G& gpu, const Schedule& schedule, std::unique_ptr<FrameSampler> sampler)
        : gpu_(gpu), schedule_(schedule), sampler_(std::move(sampler)), thresholds_(gpu, kThresholds) {
        thresholds_.copyFrom(displayThresholds().data());
        if (schedule.redundant)
            constants_.emplace(gpu);
    }

    std::size_t pixels() const { return pixelCount(area_); }

    /// Launches a program over all pixels, and waits for it.
    template <class Program>
    void stage(const Program& program) {
        gpu_.launch(program, std::int64_t(pixels()), GpuStream::compute);
        gpu_.awaitAll();
    }

    Result<void> iterateOnce(std::stop_token stop) {
        stale_ = true;
        std::optional<kroes::Resend<G>> resend;
        if (constants_ && sampler_->scene())
            resend.emplace(gpu_, *constants_, *sampler_);
        if (Result<void> sampled = sampler_->sample(done_, frame_.data(), stop); !sampled)
            return sampled;
        gpu_.awaitAll();
        if (stop.stop_requested())
            return {};
        if (schedule_.filter) {
            stage(kroes::Blur{frame_.data(), blurred_.data(), {area_.width, area_.height}, 0});
            stage(kroes::Blur{blurred_.data(), frame_.data(), {area_.width, area_.height}, 1});
        }
        addFrame();
        toneMap();
        if (std::optional<Error> error = gpu_.takeError())
            return *std::move(error);
        ++done_;
        stale_ = false;
        return {};
    }

    void addFrame() {
        if (schedule_.runningMean)
            return stage(kroes::RunningMean{frame_.data(), mean_.data(), done_});
        stage(kroes::AddToBlock{frame_.data(), block_.data(), done_});
        if ((done_ + 1) % kSamplesPerBlock == 0)
            stage(kroes::MergeBlock{block_.data(), moments_.data()});
    }

    void toneMap() {
        const kroes::Levels levels{thresholds_.data(), display_.exposure, rgbaOnDevice_.data()};
        if (schedule_.runningMean)
            stage(kroes::ShowMean{mean_.data(), levels});
        else
            stage(kroes::ShowSums{moments_.data(), block_.data(), levels});
        rgbaOnDevice_.copyTo(rgba_.data());
        gpu_.awaitAll();
    }

    Result<Health> allHealth() {
        const Result<Health> fresh = sampler_->takeHealth();
        if (!fresh)
            return fresh.error();
        health_.add(*fresh);
        return health_;
    }

    Result<FilmStatus> status() {
        if (!schedule_.runningMean) {
            const Result<std::shared_ptr<const Film>> known = film();
            if (!known)
                return known.error();
            return imageOf(**known, display_).status;
        }
        const Result<Health> health = allHealth();
        if (!health)
            return health.error();
        return FilmStatus{.samplesPerPixel = done_,
                          .meanSamplesPerPixel = double(done_),
                          .mostSamplesPerPixel = done_,
                          .health = *health,
                          .relativeError = std::numeric_limits<double>::infinity()};
    }

    /// Returns the moments of a running mean. The first iteration is not in the mean, unless it is the only one.
    Moments momentsOf(const SampledPixel& mean) const {
        if (mean.counts == 0)
            return {};
        return {dvec3(mean.radiance), dvec3(std::numeric_limits<double>::infinity()), done_ > 1 ? done_ - 1 : done_};
    }

    G& gpu_;
    Tile area_;
    std::uint64_t revision_ = 0;
    Schedule schedule_;
    std::unique_ptr<FrameSampler> sampler_;
    std::uint64_t done_ = 0;  ///< iterations done
    Health health_;
    Display display_;    ///< display settings of rgba_
    bool stale_ = true;  ///< whether rgba_ is not the current image

    // on the device
    std::optional<kroes::Constants<G>> constants_;  ///< used by K0
    GpuArray<G, SampledPixel> frame_{gpu_}, blurred_{gpu_};
    GpuArray<G, SampledPixel> mean_{gpu_};  ///< used with runningMean; without it, the next two are
    GpuArray<G, Moments> moments_{gpu_};
    GpuArray<G, PixelSums> block_{gpu_};
    GpuArray<G, std::uint8_t> rgbaOnDevice_{gpu_};
    GpuArray<G, double> thresholds_;

    std::vector<std::uint8_t> rgba_;  ///< the last image
    std::deque<Image> images_;
};

}  // namespace pdr
