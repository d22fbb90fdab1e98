#include "render/session/resolution_ladder.h"

#include <algorithm>
#include <cmath>

namespace pdr {

namespace {

constexpr double kGuess = 5e6;  ///< samples a second
constexpr double kLeast = 0.4;  ///< of a frame's time goes into pixels, whatever else takes time

}  // namespace

void ResolutionLadder::addFrame(double samples, double seconds) {
    if (seconds > 0)
        speed_.add(samples / seconds);
}

double ResolutionLadder::speed() const {
    return speed_.empty() ? kGuess : speed_.median();
}

/// Their samples and their display.
double ResolutionLadder::secondsForPixels() const {
    return std::max(kFrameSeconds - beginning_.median(), kLeast * kFrameSeconds);
}

double ResolutionLadder::secondsForSamples(double pixels) const {
    return secondsForPixels() - pixels * displaySeconds_.median();
}

int ResolutionLadder::first(ivec2 size) const {
    const double secondsOfPixel = kSamples / speed() + displaySeconds_.median();
    const double affordable = std::max(secondsForPixels() / secondsOfPixel, 1.0);
    return std::clamp(int(std::ceil(std::sqrt(double(size.x) * size.y / affordable))), 1, kCoarsest);
}

ivec2 dividedFilm(ivec2 size, int divider) {
    return glm::max((size + divider - 1) / divider, ivec2(1));
}

}  // namespace pdr
