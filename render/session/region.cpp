#include "render/session/region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace pdr {

namespace {

/// Samples per pixel after which a region without any light no longer keeps the rest waiting.
constexpr std::uint64_t kSamplesInTheDark = 256;

}  // namespace

Tile tileOf(const Region& region, ivec2 size) {
    const dvec2 film(size);
    const ivec2 from = glm::clamp(ivec2(glm::floor(region.from * film)), ivec2(0), size - 1);
    const ivec2 to = glm::clamp(ivec2(glm::ceil(region.to * film)), from + 1, size);
    return {from.x, from.y, to.x - from.x, to.y - from.y};
}

void RegionView::clear() {
    status_.reset();
    history_.clear();
}

void RegionView::choose(const std::optional<Region>& region) {
    if (region == region_)
        return;
    clear();
    region_ = region;
}

std::optional<Tile> RegionView::tile(ivec2 size) const {
    return region_ ? std::optional(tileOf(*region_, size)) : std::nullopt;
}

bool RegionView::isDue(std::uint64_t samples, const Tone& tone) const {
    return region_ && (!status_ || tone != tone_ || 8 * samples >= 9 * status_->samplesPerPixel);
}

void RegionView::look(const Film& film, const Tone& tone, double seconds, DenoisedView* denoised) {
    const Tile part = *tile(film.size());
    const FilmStatus own = film.status(tone, part);
    const ShownStatus shown = shownStatus(own, denoised, denoised ? denoised->errorOver(part, tone) : std::nullopt);
    status_ = shown.status;
    of_ = shown.of;
    if (std::exchange(tone_, tone) != tone)
        history_.forgetErrors();
    history_.add(seconds, own, shown);
}

double RegionView::error() const {
    if (!status_)
        return std::numeric_limits<double>::infinity();
    const std::uint64_t samples = status_->samplesPerPixel;
    const bool isEmpty = status_->tissuePixels == 0 && samples >= kSamplesToEstimate;
    const bool isDark = !std::isfinite(status_->displayError) && samples >= kSamplesInTheDark;
    return isEmpty || isDark ? 0 : status_->displayError;
}

std::optional<RegionStatus> RegionView::status(double target) const {
    if (!region_ || !status_)
        return std::nullopt;
    return RegionStatus{*region_, *status_, of_, !isFirst(target), history_.steps(of_), history_.points(of_)};
}

}  // namespace pdr
