#include "render/slice/grey_window.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

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

/// Returns the level by comparisons that need no jump: neighbouring pixels may lie on either side of the window.
template <class Function>
std::uint8_t levelOf(const Function& function, float hu) {
    const double level = function(double(hu));
    const double lit = level > 0 ? level : 0;  // also where it is not a number
    const double halfMore = (lit < 255 ? lit : 255) + 0.5;
    return std::uint8_t(int(halfMore));
}

/// Returns the four bytes of a pixel as one number, in this machine's order.
std::uint32_t packed(const Ground& colour, std::uint8_t opacity) {
    const std::array<std::uint8_t, 4> bytes{colour[0], colour[1], colour[2], opacity};
    return std::bit_cast<std::uint32_t>(bytes);
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

void paintGrey(const GreyWindow& window, std::span<const float> hu, const Ground& ground,
               std::span<std::uint8_t> pixels) {
    constexpr std::size_t kTogether = 512;
    const std::uint32_t one = packed({1, 1, 1}, 0), opaque = packed({0, 0, 0}, 255), outside = packed(ground, 255);
    withFunction(window, [&](const auto& function) {
        // Levels first, into memory of their own, which the compiler knows to be nothing else: it computes many at
        // once.
        std::array<std::uint8_t, kTogether> levels;
        for (std::size_t first = 0; first < hu.size(); first += levels.size()) {
            const std::span<const float> some = hu.subspan(first, std::min(levels.size(), hu.size() - first));
            for (std::size_t i = 0; i < some.size(); ++i)
                levels[i] = levelOf(function, some[i]);
            std::array<std::uint32_t, kTogether> colours;
            for (std::size_t i = 0; i < some.size(); ++i)
                colours[i] = some[i] == some[i] ? std::uint32_t(levels[i]) * one | opaque : outside;
            std::memcpy(&pixels[4 * first], colours.data(), 4 * some.size());
        }
    });
}

std::vector<std::uint8_t> greyPixels(const GreyWindow& window, std::span<const float> hu, const Ground& ground) {
    std::vector<std::uint8_t> pixels(4 * hu.size());
    paintGrey(window, hu, ground, pixels);
    return pixels;
}

}  // namespace pdr
