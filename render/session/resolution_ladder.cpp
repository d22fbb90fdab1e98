#include "render/session/resolution_ladder.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

/// Samples per second before any are known: what two to four cores make. A device that is faster is known to be so
/// after one image; the first image of a slower one would keep the user waiting.
constexpr double kGuess = 1e6;
constexpr double kCoarseEditGuess = 0.012;  ///< seconds to lay a coarse change on the full image, on two cores
constexpr double kEditBeginning = 0.025;    ///< seconds before the first sample after an edit, of 600 slices
constexpr double kEditedGuess = 4e-7;       ///< seconds to show a pixel of the first image after an edit, on two cores
/// Time for the first image of a full film made on features, of one sample, in parts of that sample's.
constexpr double kFeaturedSamples = 3;
/// Divider below which a coarse film and its guide take more than an eighth of the time for such an image.
constexpr int kFinestBefore = 6;
constexpr double kLeast = 0.4;  ///< least fraction of a frame's time for pixels, whatever else takes time
/// The same after an edit, whose samples tell no more than its guide does not (edit/foretold.h).
constexpr double kLeastOfEdit = 0.2;

}  // namespace

void ResolutionLadder::addFrame(double samples, double seconds) {
    if (seconds > 0)
        speed_.add(samples / seconds);
}

double ResolutionLadder::speed() const {
    return speed_.median(kGuess);
}

/// Returns the time for the samples and the display of all pixels [s].
double ResolutionLadder::secondsForPixels() const {
    return std::max(kFrameSeconds - beginning_.median(), kLeast * kFrameSeconds);
}

/// Returns the recent time to show one pixel of a coarse film [s].
double ResolutionLadder::secondsToShowCoarse() const {
    return guidedSeconds_.median(displaySeconds_.median());
}

double ResolutionLadder::secondsForSamples(double pixels) const {
    return secondsForPixels() - pixels * secondsToShowCoarse();
}

/// Returns the time that passes before the first sample after an edit [s]. No more than what films of other views took
/// is expected before there was one.
double ResolutionLadder::secondsToBeginEdit() const {
    return editBeginning_.median(std::min(beginning_.median(), kEditBeginning));
}

bool ResolutionLadder::editIsInTime(ivec2 size) const {
    const double display = editedSeconds_.median(kEditedGuess);
    return secondsToBeginEdit() + double(size.x) * size.y * (1 / speed() + display) <= kEditSeconds;
}

double ResolutionLadder::secondsForEdit(bool moving) const {
    const double all = moving ? kCoarseEditSeconds : kRestingEditSeconds;
    return std::max(all - secondsToBeginEdit() - coarseEditSeconds_.median(kCoarseEditGuess), kLeastOfEdit * all);
}

int ResolutionLadder::forEdit(ivec2 size, bool moving) const {
    const double affordable = std::max(secondsForEdit(moving) * speed() / kSamples, 1.0);
    return std::clamp(int(std::ceil(std::sqrt(double(size.x) * size.y / affordable))), 2, kCoarsest);
}

int ResolutionLadder::nextOnFeatures(int divider, ivec2 size) const {
    const double seconds = kFeaturedSamples * size.x * size.y / speed();
    return next(divider) < kFinestBefore && seconds <= kFeaturedSeconds ? 1 : next(divider);
}

int ResolutionLadder::first(ivec2 size) const {
    const double pixels = double(size.x) * size.y, samples = kSamples / speed();
    if (pixels * (samples + displaySeconds_.median()) <= secondsForPixels())
        return 1;
    const double affordable = std::max(secondsForPixels() / (samples + secondsToShowCoarse()), 1.0);
    return std::clamp(int(std::ceil(std::sqrt(pixels / affordable))), 1, kCoarsest);
}

ivec2 dividedFilm(ivec2 size, int divider) {
    return glm::max(size / divider, ivec2(1));
}

}  // namespace pdr
