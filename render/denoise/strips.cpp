#include "render/denoise/strips.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pdr::denoise {
namespace {

/// Sums over a pixel, a column of a strip, or all columns before one.
struct Sums {
    double value = 0, variance = 0;
};

/// A copy of the image in which u runs along the rows.
class Sheet {
  public:
    Sheet(const Plane& values, const Plane& variance, bool steep)
        : size_(steep ? ivec2(values.size().y, values.size().x) : values.size()),
          pixels_(std::size_t(size_.x) * std::size_t(size_.y)) {
        for (int y = 0; y < values.size().y; ++y)
            for (int x = 0; x < values.size().x; ++x)
                pixels_[steep ? at(y, x) : at(x, y)] = {values.row(y)[x], variance.row(y)[x]};
    }

    ivec2 size() const { return size_; }
    Sums column(int u, int v, int width) const {
        Sums sum;
        for (int i = 0; i < width; ++i) {
            const Pixel& pixel = pixels_[at(u, v + i)];
            sum.value += double(pixel.value);
            sum.variance += double(pixel.variance);
        }
        return sum;
    }

  private:
    struct Pixel {
        float value, variance;
    };

    std::size_t at(int u, int v) const { return std::size_t(v) * std::size_t(size_.x) + std::size_t(u); }

    ivec2 size_;
    std::vector<Pixel> pixels_;
};

/// Scans all strips of one direction.
class Scan {
  public:
    Scan(const Sheet& sheet, int index, double leastZ)
        : sheet_(sheet), index_(index), way_(index), squaredZ_(leastZ * leastZ) {
        for (int u = 0; u < sheet.size().x; ++u)
            shifts_.push_back(way_.across(u, 0));
        first_ = -std::max(0, shifts_.back());
        rows_ = std::max(0, sheet.size().y - way_.width + 1 - std::min(0, shifts_.back()) - first_);
    }

    void addTo(std::vector<Strip>& strips, const std::stop_token& stop) const {
        std::vector<std::vector<Strip>> found{std::size_t(rows_)};
        eachBand(rows_, stop, [&](int begin, int end) {
            std::vector<Sums> before(shifts_.size() + 1);
            for (int row = begin; row < end; ++row)
                found[std::size_t(row)] = inRow(first_ + row, before);
        });
        for (const std::vector<Strip>& row : found)
            strips.insert(strips.end(), row.begin(), row.end());
    }

  private:
    bool inside(int u, int v) const {
        const int across = v + shifts_[std::size_t(u)];
        return across >= 0 && across + way_.width <= sheet_.size().y;
    }

    std::vector<Strip> inRow(int v, std::vector<Sums>& before) const {
        // Find the columns in which a strip at v is inside the image
        int begin = 0, end = sheet_.size().x;
        while (begin < end && !inside(begin, v))
            ++begin;
        while (end > begin && !inside(end - 1, v))
            --end;
        before[std::size_t(begin)] = {};
        for (auto u = std::size_t(begin); u < std::size_t(end); ++u) {
            const Sums column = sheet_.column(int(u), v + shifts_[u], way_.width);
            before[u + 1] = {before[u].value + column.value, before[u].variance + column.variance};
        }
        // Collect the strips whose sum is beyond the limit
        std::vector<Strip> strong;
        const auto length = std::size_t(way_.length);
        for (auto u = std::size_t(begin); u + length <= std::size_t(end); ++u) {
            const Sums &from = before[u], &to = before[u + length];
            const double sum = to.value - from.value, variance = to.variance - from.variance;
            if (variance > 0 && sum * sum > squaredZ_ * variance)
                strong.push_back({index_, int(u), v, float(sum / std::sqrt(variance))});
        }
        return strong;
    }

    const Sheet& sheet_;
    int index_;
    Direction way_;
    double squaredZ_;
    std::vector<int> shifts_;
    int first_, rows_;  ///< first v of a strip, and number of them
};

}  // namespace

Direction::Direction(int index) {
    const double angle = std::numbers::pi * index / kDirections, x = std::cos(angle), y = std::sin(angle);
    steep = std::fabs(y) > std::fabs(x);
    slope = steep ? x / y : y / x;
    stretch = std::sqrt(1 + slope * slope);
    length = int(std::lround(kStripLength / stretch));
    width = int(std::lround(kStripWidth * stretch));
}

int Direction::across(int u, int v) const {
    return v + int(std::lround(slope * u));
}

std::vector<Strip> strongStrips(const Plane& values, const Plane& variance, double leastZ,
                                const std::stop_token& stop) {
    const Sheet lying(values, variance, false), upright(values, variance, true);
    std::vector<Strip> strips;
    for (int index = 0; index < kDirections; ++index)
        Scan(Direction(index).steep ? upright : lying, index, leastZ).addTo(strips, stop);
    return strips;
}

}  // namespace pdr::denoise
