#include "render/slice/grey_window.h"

#include <algorithm>
#include <cmath>

namespace pdr {
namespace {

// Each function is computed in double with a single division at its end, so that a level that lies exactly between two
// is found there. White is 255.

struct Linear {
    double middle, width;
    double operator()(double hu) const { return (255 * (hu - middle) + 127.5 * width) / width; }
};

struct Sigmoid {
    double centre, width;
    double operator()(double hu) const { return 255 / (1 + std::exp(-4 * (hu - centre) / width)); }
};

template <class Function>
std::uint8_t levelOf(const Function& function, float hu) {
    const double level = function(double(hu));
    return level > 0 ? std::uint8_t(std::floor(std::min(level, 255.0) + 0.5))
                     : std::uint8_t(0);  // also where it is not a number
}

/// Calls `use` with the function of `window`.
template <class Use>
auto withFunction(const GreyWindow& window, const Use& use) {
    switch (window.function) {
        case VoiFunction::linearExact:
            return use(Linear{window.centre, window.width});
        case VoiFunction::sigmoid:
            return use(Sigmoid{window.centre, window.width});
        case VoiFunction::linear:
            break;
    }
    return use(Linear{window.centre - 0.5, window.width - 1});
}

}  // namespace

bool GreyWindow::valid() const {
    return std::isfinite(centre) && std::isfinite(width) && (function == VoiFunction::linear ? width >= 1 : width > 0);
}

std::uint8_t greyLevel(const GreyWindow& window, float hu) {
    return withFunction(window, [&](const auto& function) { return levelOf(function, hu); });
}

std::vector<std::uint8_t> greyPixels(const GreyWindow& window, std::span<const float> hu, const Ground& ground) {
    std::vector<std::uint8_t> pixels(4 * hu.size());
    withFunction(window, [&](const auto& function) {
        for (std::size_t i = 0; i < hu.size(); ++i) {
            const bool outside = std::isnan(hu[i]);
            const std::uint8_t level = levelOf(function, hu[i]);
            for (std::size_t channel = 0; channel < 3; ++channel)
                pixels[4 * i + channel] = outside ? ground[channel] : level;
            pixels[4 * i + 3] = 255;
        }
    });
    return pixels;
}

}  // namespace pdr
