#include "ui/view/upsampled.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pdr::ui {
namespace {

constexpr int kTaps = 4, kChannels = 4;

/// The source pixels and weights of one pixel of the result.
struct Taps {
    std::array<int, kTaps> from;  ///< source pixels
    std::array<float, kTaps> weight;
};

/// Returns the taps of `to` pixels along a line of `from` source pixels. Beyond its ends the last pixel is repeated.
std::vector<Taps> tapsOf(int from, int to) {
    std::vector<Taps> taps(std::size_t(std::max(to, 0)));
    for (int i = 0; i < to; ++i) {
        const double place = (i + 0.5) * from / to - 0.5, first = std::floor(place);
        const float t = float(place - first), s = 1 - t;
        Taps& one = taps[std::size_t(i)];
        one.weight = {s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6, (4 - 6 * s * s + 3 * s * s * s) / 6,
                      t * t * t / 6};
        for (int tap = 0; tap < kTaps; ++tap)
            one.from[std::size_t(tap)] = std::clamp(int(first) - 1 + tap, 0, from - 1);
    }
    return taps;
}

/// Enlarges one row of the source to the width of the result, with the channels of each pixel interleaved.
void widen(const uchar* row, const std::vector<Taps>& taps, float* wide) {
    for (const Taps& tap : taps) {
        for (int channel = 0; channel < kChannels; ++channel) {
            float sum = 0;
            for (std::size_t i = 0; i < kTaps; ++i)
                sum += tap.weight[i] * float(row[kChannels * tap.from[i] + channel]);
            wide[channel] = sum;
        }
        wide += kChannels;
    }
}

}  // namespace

QImage upsampled(const QImage& image, QSize size) {
    // Enlarge each row
    const std::vector<Taps> across = tapsOf(image.width(), size.width()), down = tapsOf(image.height(), size.height());
    const std::size_t width = across.size() * kChannels;
    std::vector<float> wide(width * std::size_t(image.height()));
    for (int y = 0; y < image.height(); ++y)
        widen(image.constScanLine(y), across, &wide[width * std::size_t(y)]);
    // Enlarge each column
    QImage result(size, image.format());
    for (int y = 0; y < size.height(); ++y) {
        const Taps& tap = down[std::size_t(y)];
        std::array<const float*, kTaps> rows;
        for (std::size_t i = 0; i < kTaps; ++i)
            rows[i] = &wide[width * std::size_t(tap.from[i])];
        uchar* out = result.scanLine(y);
        for (std::size_t x = 0; x < width; ++x) {
            const float rounded = tap.weight[0] * rows[0][x] + tap.weight[1] * rows[1][x] + tap.weight[2] * rows[2][x] +
                                  tap.weight[3] * rows[3][x] + 0.5F;
            out[x] = uchar(rounded);
        }
    }
    return result;
}

}  // namespace pdr::ui
