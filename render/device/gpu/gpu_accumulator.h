#pragma once
/// The film in a GPU's memory. Only finished images cross the bus: the GPU copies them asynchronously, in a stream of
/// their own, to two buffers in host memory, while the next samples are taken.

#include <algorithm>
#include <array>
#include <cassert>
#include <chrono>
#include <cstring>
#include <optional>
#include <utility>

#include "render/device/accumulator.h"
#include "render/device/gpu/film_kernels.h"
#include "render/device/gpu/gpu_scene.h"
#include "render/device/gpu/launch_size.h"
#include "render/device/gpu/tracer.h"

namespace pdr {

template <Gpu G>
class GpuAccumulator final : public Accumulator {
  public:
    /// Keeps references to `gpu` and `scene`, which must outlive it. restart() must be called first.
    GpuAccumulator(G& gpu, const GpuScene<G>& scene) : gpu_(gpu), scene_(scene) {}
    ~GpuAccumulator() override {
        gpu_.awaitAll();
        gpu_.takeError();  // nobody is left to report it to
    }

    using Accumulator::accumulate;
    using Accumulator::resolve;

    Tile area() const override { return progress_.area(); }
    Result<void> accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) override;
    Result<void> resolve(const Display& display, std::stop_token stop) override;
    Result<Image> readback() override;
    int maxInFlight() const override { return kMaxInFlight; }
    Result<std::shared_ptr<const Film>> film() override;
    Result<void> resume(const Film& film) override;
    Result<void> restart(const Tile& area, std::uint64_t revision) override;

  private:
    static constexpr int kMaxInFlight = 2;

    /// An image on its way.
    struct Slot {
        explicit Slot(G& gpu) : onDevice(gpu), onHost(gpu) {}
        void resize(std::size_t bytes) {
            onDevice.resize(bytes);
            onHost.resize(bytes);
        }

        GpuArray<G, std::byte> onDevice;
        PinnedArray<G, std::byte> onHost;
        typename G::Event developed{}, arrived{};
        std::uint64_t id = 0;
        SampleCounts samples;
        double exposure = 1;
        std::optional<Image> denoised;  ///< denoised image, made on the host: if set, nothing else of the slot counts
    };

    std::int64_t pixels() const { return layout_.pixels; }
    void launch(const Tile& tile, SampleRange samples);
    Result<void> resolveOnHost(const Display& display, const std::stop_token& stop);
    Image imageIn(const Slot& slot) const;

    G& gpu_;
    const GpuScene<G>& scene_;
    TileProgress progress_;
    std::uint64_t revision_ = 0;
    FrameLayout layout_{};
    LaunchSize launchSize_{1};

    GpuArray<G, PixelSums> block_{gpu_};
    GpuArray<G, Moments> moments_{gpu_};
    GpuArray<G, vec3> radiance_{gpu_};
    PathListMemory<G> paths_{gpu_};
    GpuArray<G, std::uint32_t> seen_{gpu_};  ///< what was seen and is not yet in block_
    GpuArray<G, StatusSums> sums_{gpu_};
    GpuArray<G, ErrorCounts> errors_{gpu_};
    GpuArray<G, GpuHealth> health_{gpu_};
    GpuArray<G, double> thresholds_{gpu_};
    GpuArray<G, float> greys_{gpu_}, lights_{gpu_};  ///< tables of the tone curves
    GpuArray<G, vec2> hues_{gpu_};
    std::array<Slot, kMaxInFlight> slots_{Slot(gpu_), Slot(gpu_)};
    std::uint64_t shown_ = 0, taken_ = 0;
    Development development_;                      ///< denoises images on the host
    std::array<typename G::Event, 2> launched_{};  ///< the ends of the last two launches
    std::uint64_t launches_ = 0;
};

template <Gpu G>
Result<void> GpuAccumulator<G>::restart(const Tile& area, std::uint64_t revision) {
    gpu_.awaitAll();  // no work may be under way on what is emptied
    progress_ = TileProgress(area);
    revision_ = revision;
    layout_ = {std::int64_t(pixelCount(area))};
    launchSize_ = LaunchSize(pixels());
    taken_ = shown_;
    development_ = {};
    const std::size_t all = std::size_t(pixels());
    block_.resize(all);
    moments_.resize(all);
    seen_.resize(all);
    sums_.resize(std::size_t(layout_.sums()));
    errors_.resize(kCountPlaces);
    health_.resize(1);
    for (Slot& slot : slots_)
        slot.resize(std::size_t(layout_.bytes()));
    block_.clear();
    moments_.clear();
    seen_.clear();
    errors_.clear();
    gpu_.launch(ForgetFaultsKernel{health_.data()}, 1, GpuStream::compute);
    if (thresholds_.size() == 0) {
        thresholds_.assign(displayThresholds());
        greys_.assign({displayCurve(), std::size_t(GreyTable::kEntries)});
        hues_.assign({hueCurve(), std::size_t(HueTable::kEntries)});
        lights_.assign({lightCurve(), std::size_t(LightTable::kEntries)});
    }
    return takeStatus(gpu_);
}

template <Gpu G>
void GpuAccumulator<G>::launch(const Tile& tile, SampleRange samples) {
    const SampleGrid grid{tile, samples};
    radiance_.resize(std::size_t(grid.pixels()) * samples.count);
    const int stride = area().width;
    const std::ptrdiff_t corner = std::ptrdiff_t(tile.y - area().y) * stride + (tile.x - area().x);
    const TraceTarget target{grid, radiance_.data(), health_.data(), seen_.data() + corner, stride};
    traceAndAdd(gpu_, scene_.flat(), target, paths_, block_.data() + corner, moments_.data() + corner);
    progress_.advance(tile, samples.end());
}

/// Keeps one launch under way while the next is enqueued, and no more, so that a stop takes effect within a launch.
template <Gpu G>
Result<void> GpuAccumulator<G>::accumulate(const Tile& region, std::uint32_t n, std::stop_token stop) {
    if (Result<void> scene = scene_.isThere(); !scene)
        return scene;
    for (const EvenTile& even : progress_.evenTiles(progress_.cellsAround(region)))
        for (std::uint32_t done = 0; done < n && !stop.stop_requested();) {
            const std::uint32_t samples = std::min(n - done, launchSize_.samples());
            launch(even.tile, {even.next + done, samples});
            done += samples;
            gpu_.record(launched_[launches_ % 2], GpuStream::compute);
            ++launches_;
            gpu_.await(launched_[launches_ % 2]);
            launchSize_.ended(samples);
        }
    return takeStatus(gpu_);
}

template <Gpu G>
Result<void> GpuAccumulator<G>::resolve(const Display& display, std::stop_token stop) {
    assert(shown_ - taken_ < kMaxInFlight);
    if (display.denoised)
        return resolveOnHost(display, stop);
    Slot& slot = slots_[shown_ % kMaxInFlight];
    slot.denoised.reset();
    slot.id = ++shown_;
    slot.samples = progress_.counts();
    slot.exposure = double(display.exposure);
    // Develop the image on the device
    const DisplayTransform transform{thresholds_.data(), greys_.data(), hues_.data(),
                                     lights_.data(),     slot.exposure, display.curve};
    std::byte* frame = slot.onDevice.data();
    gpu_.launch(ResolveKernel{layout_, block_.data(), moments_.data(), transform, frame, sums_.data(), errors_.data()},
                layout_.sums(), GpuStream::compute);
    gpu_.launch(CountErrorsKernel{errors_.data(), frame}, kErrorBins, GpuStream::compute);
    gpu_.launch(FinalizeKernel{layout_, sums_.data(), health_.data(), slot.id, frame}, layout_.totals(),
                GpuStream::compute);
    std::memset(slot.onHost.data(), 0,
                sizeof slot.id);  // what an earlier image left there must not be taken for this one
    std::memset(slot.onHost.data() + layout_.tailAt(), 0, sizeof slot.id);
    // Copy it to the host beside the next samples
    gpu_.record(slot.developed, GpuStream::compute);
    gpu_.wait(GpuStream::copy, slot.developed);
    gpu_.copyToHost(slot.onHost.data(), frame, std::size_t(layout_.bytes()), GpuStream::copy);
    gpu_.record(slot.arrived, GpuStream::copy);
    return takeStatus(gpu_);
}

template <Gpu G>
Result<void> GpuAccumulator<G>::resolveOnHost(const Display& display, const std::stop_token& stop) {
    const Result<std::shared_ptr<const Film>> known = film();
    if (!known)
        return known.error();
    slots_[shown_++ % kMaxInFlight].denoised = development_.image(**known, display, stop);
    return {};
}

template <Gpu G>
Result<Image> GpuAccumulator<G>::readback() {
    assert(taken_ < shown_);
    Slot& slot = slots_[taken_++ % kMaxInFlight];
    if (slot.denoised)
        return *std::exchange(slot.denoised, std::nullopt);
    gpu_.await(slot.arrived);
    if (Result<void> done = takeStatus(gpu_); !done)
        return done.error();
    std::uint64_t head, tail;
    std::memcpy(&head, slot.onHost.data(), sizeof head);
    std::memcpy(&tail, slot.onHost.data() + layout_.tailAt(), sizeof tail);
    if (head != slot.id || tail != slot.id)
        return Error{phrase("an image was damaged on its way from the device"), gpu_.name(),
                     phrase("Choose another device; this one cannot be trusted."), ErrorKind::deviceLost};
    return imageIn(slot);
}

template <Gpu G>
Image GpuAccumulator<G>::imageIn(const Slot& slot) const {
    const std::byte* bytes = slot.onHost.data();
    FrameLayout::Head head;
    std::memcpy(&head, bytes, sizeof head);
    StatusSums all;
    for (std::int64_t i = 0; i < layout_.totals(); ++i) {
        StatusSums one;
        std::memcpy(&one, bytes + layout_.totalsAt() + i * std::int64_t(sizeof one), sizeof one);
        all.add(one);
    }
    const auto* rgba = reinterpret_cast<const std::uint8_t*>(bytes + layout_.pixelsAt());
    return {{rgba, rgba + pixels() * 4},
            statusOf(all, std::size_t(pixels()), slot.samples, toHealth(head.health), {head.errors, slot.exposure})};
}

template <Gpu G>
Result<std::shared_ptr<const Film>> GpuAccumulator<G>::film() {
    FilmContent content{
        progress_, std::vector<Moments>(std::size_t(pixels())), std::vector<PixelSums>(std::size_t(pixels())), {}};
    GpuHealth health;
    moments_.copyTo(content.moments.data());
    block_.copyTo(content.block.data());
    health_.copyTo(&health);
    gpu_.awaitAll();
    if (Result<void> done = takeStatus(gpu_); !done)
        return done.error();
    content.health = toHealth(health);
    return std::make_shared<const Film>(revision_, std::move(content));
}

template <Gpu G>
Result<void> GpuAccumulator<G>::resume(const Film& film) {
    assert(film.area() == area());
    FilmContent content = film.content();
    development_ = {};
    const GpuHealth health = toGpuHealth(content.health);
    moments_.copyFrom(content.moments.data());
    block_.copyFrom(content.block.data());
    seen_.clear();
    health_.copyFrom(&health);
    gpu_.awaitAll();
    progress_ = std::move(content.progress);
    return takeStatus(gpu_);
}

}  // namespace pdr
