#include "app/bench/prediction/stated_error.h"

#include <cmath>
#include <memory>
#include <utility>

#include "render/film/display_transform.h"

namespace pdr::bench {
namespace {

/// Returns the fraction of the tissue that is shown within `levels` of the truth.
double partWithin(double levels, const Film& film, const Film& truth, float exposure) {
    const DisplayTransform transform = displayTransform(exposure);
    double tissue = 0, within = 0;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y), best = truth.pixel(x, y);
            if (!pixel.tissue)
                continue;
            const dvec3 off(glm::abs(transform.exactLevels(pixel.mean) - transform.exactLevels(best.mean)));
            ++tissue;
            within += glm::all(glm::lessThanEqual(off, dvec3(levels)));
        }
    return tissue > 0 ? within / tissue : 1;
}

/// An image in progress.
class GrowingImage {
  public:
    static Result<GrowingImage> of(const Scene& scene, Device& device) {
        auto film = startFilm(device, scene);
        if (!film)
            return film.error();
        return GrowingImage(*std::move(film));
    }
    Result<std::shared_ptr<const Film>> grown(std::uint64_t samples) {
        if (auto ok = film_->accumulate(std::uint32_t(samples - done_), {}); !ok)
            return ok.error();
        done_ = samples;
        return film_->film();
    }

  private:
    explicit GrowingImage(std::unique_ptr<Accumulator> film) : film_(std::move(film)) {}

    std::unique_ptr<Accumulator> film_;
    std::uint64_t done_ = 0;
};

Result<std::shared_ptr<const Film>> filmOf(const Scene& scene, std::uint64_t samples, Device& device) {
    auto image = GrowingImage::of(scene, device);
    if (!image)
        return image.error();
    return image->grown(samples);
}

}  // namespace

Result<std::vector<StatedError>> statedErrors(Scene scene, const std::vector<std::uint64_t>& samples, int seeds,
                                              std::uint32_t truth, float exposure, Device& device) {
    std::vector<StatedError> errors;
    errors.reserve(samples.size());
    for (const std::uint64_t count : samples)
        errors.push_back({.samples = count});
    scene.seed = 0;
    const auto best = filmOf(scene, truth, device);
    if (!best)
        return best.error();
    for (int seed = 1; seed <= seeds; ++seed) {
        scene.seed = std::uint64_t(seed);
        ++scene.revision;
        auto image = GrowingImage::of(scene, device);
        if (!image)
            return image.error();
        for (StatedError& error : errors) {
            const auto film = image->grown(error.samples);
            if (!film)
                return film.error();
            const FilmStatus status = (*film)->status(double(exposure));
            error.within += partWithin(status.displayError, **film, **best, exposure) / seeds;
            error.fewBright += status.fewBrightSamples;
        }
    }
    return errors;
}

}  // namespace pdr::bench
