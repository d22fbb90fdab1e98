#include "render/denoise/lost_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "render/base/significance.h"
#include "render/denoise/strips.h"

namespace pdr::denoise {
namespace {

constexpr double kFalseAlarms = 0.05;  ///< share of images with a false line
constexpr double kGap = 1, kSide = 3;  ///< pixels between a line and its sides, and width of the sides
constexpr double kSideZ = 4;       ///< sigmas by which a line differs from each side: an edge has some thousand strips
constexpr double kLikeSide = 0.5;  ///< share of the loss: an edge that is lost in full height differs by less
constexpr double kMostKept = 0.5;  ///< share of a lost line's contrast that is left, at most
constexpr double kSeen = 0.05;     ///< contrast that is barely visible
/// Share of the line's mean loss that each third of it must have lost: else it is a blot.
constexpr double kEverywhere = 0.3;
constexpr float kApart = 10;    ///< pixels between two lines; nearer ones are the same line
constexpr float kStraight = 4;  ///< pixels off a line at which another one still continues it

/// Means over the pixels of a strip, or of one of its sides.
struct Means {
    double raw = 0, smooth = 0;
    double variance = 0;   ///< variance of one pixel's noise
    double ofRemoved = 0;  ///< mean square of what denoising removed
    int pixels = 0;

    double lost() const { return raw - smooth; }
};

class Judge {
  public:
    Judge(const Plane& raw, const Plane& smooth, const Plane& variance, double leastZ)
        : raw_(raw), smooth_(smooth), variance_(variance), leastZ_(leastZ) {}

    bool isLostLine(const Strip& strip) const {
        const Direction way(strip.direction);
        const int gap = int(std::lround(kGap * way.stretch)), wide = int(std::lround(kSide * way.stretch));
        const Means line = along(strip, 0, way.length, 0, way.width);
        const Means left = along(strip, 0, way.length, -gap - wide, wide);
        const Means right = along(strip, 0, way.length, way.width + gap, wide);
        const double sign = strip.z > 0 ? 1 : -1, lost = sign * line.lost();
        return left.pixels > 0 && right.pixels > 0 && isClear(line, left, right) &&
               std::min(sharpness(line, left, sign), sharpness(line, right, sign)) > kLikeSide * lost &&
               lost > kSeen * (left.raw + right.raw) / 2 && isGone(line, left, right) && isLostEverywhere(strip, lost);
    }

  private:
    /// Returns the means over columns `begin` to `end` of the strip, `width` pixels from `across`, as far as they are
    /// in the image.
    Means along(const Strip& strip, int begin, int end, int across, int width) const {
        const Direction way(strip.direction);
        Means sum;
        for (int u = strip.u + begin; u < strip.u + end; ++u)
            for (int i = 0, v = way.across(u, strip.v) + across; i < width; ++i, ++v)
                add(way.steep ? ivec2(v, u) : ivec2(u, v), sum);
        const double share = 1.0 / std::max(sum.pixels, 1);
        return {share * sum.raw, share * sum.smooth, share * sum.variance, share * sum.ofRemoved, sum.pixels};
    }

    void add(ivec2 at, Means& sum) const {
        const ivec2 size = raw_.size();
        if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y)
            return;
        const double raw = double(raw_.row(at.y)[at.x]), smooth = double(smooth_.row(at.y)[at.x]);
        sum.raw += raw;
        sum.smooth += smooth;
        sum.variance += double(variance_.row(at.y)[at.x]);
        sum.ofRemoved += (raw - smooth) * (raw - smooth);
        ++sum.pixels;
    }

    /// Returns whether the loss exceeds the noise, and also what was removed beside the line by chance: where the image
    /// has a grain, that is more than noise.
    bool isClear(const Means& line, const Means& left, const Means& right) const {
        const double beside = (left.ofRemoved + right.ofRemoved) / 2;
        return line.lost() * line.lost() * line.pixels > leastZ_ * leastZ_ * std::max(line.variance, beside);
    }

    /// Returns the difference between the line and that side; 0 where it may be noise.
    static double sharpness(const Means& line, const Means& side, double sign) {
        const double off = sign * (line.raw - side.raw);
        return off > kSideZ * std::sqrt(line.variance / line.pixels + side.variance / side.pixels) ? off : 0;
    }

    static bool isGone(const Means& line, const Means& left, const Means& right) {
        const double was = line.raw - (left.raw + right.raw) / 2, is = line.smooth - (left.smooth + right.smooth) / 2;
        return is / was < kMostKept;
    }

    bool isLostEverywhere(const Strip& strip, double lost) const {
        const Direction way(strip.direction);
        const double sign = strip.z > 0 ? 1 : -1;
        for (int third = 0; third < 3; ++third) {
            const Means part = along(strip, third * way.length / 3, (third + 1) * way.length / 3, 0, way.width);
            if (sign * part.lost() < kEverywhere * lost)
                return false;
        }
        return true;
    }

    const Plane &raw_, &smooth_, &variance_;
    double leastZ_;
};

LostLine lineOf(const Strip& strip) {
    const Direction way(strip.direction);
    const auto place = [&](int u) {
        const float along = float(u) + 0.5f, across = float(way.across(u, strip.v)) + 0.5f * float(way.width);
        return way.steep ? vec2(across, along) : vec2(along, across);
    };
    return {place(strip.u), place(strip.u + way.length - 1), strip.z < 0};
}

/// Returns a place in the frame of a line: x along it from its beginning, y across it.
vec2 seenFrom(const LostLine& line, vec2 place) {
    const vec2 along = glm::normalize(line.end - line.begin), from = place - line.begin;
    return {glm::dot(from, along), from.y * along.x - from.x * along.y};
}

/// Returns whether `other` is the same line, or a neighbour that was found only because of it.
bool isNear(const LostLine& line, const LostLine& other) {
    const float length = glm::length(line.end - line.begin);
    const vec2 middle = seenFrom(line, (other.begin + other.end) / 2.0f);
    return glm::length(middle - vec2(glm::clamp(middle.x, 0.0f, length), 0)) < kApart;
}

/// Returns `line` extended by a line that continues it straight on, or nothing.
std::optional<LostLine> lengthened(const LostLine& line, const LostLine& by) {
    vec2 from = seenFrom(line, by.begin), to = seenFrom(line, by.end);
    if (from.x > to.x)
        std::swap(from, to);
    const float length = glm::length(line.end - line.begin);
    if (by.darker != line.darker || std::max(std::fabs(from.y), std::fabs(to.y)) > kStraight || from.x > length ||
        to.x < 0 || (from.x >= 0 && to.x <= length))
        return std::nullopt;
    const vec2 along = (line.end - line.begin) / length;
    return LostLine{line.begin + std::min(from.x, 0.0f) * along, line.begin + std::max(to.x, length) * along,
                    line.darker};
}

/// Drops pieces that a clearer line has reached since they were found.
void dropCovered(std::vector<LostLine>& lines) {
    std::vector<LostLine> kept;
    for (const LostLine& line : lines)
        if (std::ranges::none_of(kept, [&](const LostLine& clearer) { return isNear(clearer, line); }))
            kept.push_back(line);
    lines = std::move(kept);
}

}  // namespace

std::vector<LostLine> lostLines(const Plane& raw, const Plane& smooth, const Plane& variance,
                                const std::stop_token& stop) {
    // Find strips whose sum exceeds the noise, allowing for the number of comparisons
    const double comparisons = double(raw.size().x) * raw.size().y * kDirections;
    const double leastZ = allowedZ(int(std::min(comparisons, double(std::numeric_limits<int>::max()))), kFalseAlarms);
    const Plane removed = combined([](float noisy, float calm) { return noisy - calm; }, raw, smooth);
    std::vector<Strip> strips = strongStrips(removed, variance, leastZ, stop);
    std::ranges::stable_sort(strips, std::greater(), [](const Strip& strip) { return std::fabs(strip.z); });
    // Turn the strips into lines, the clearest first, and extend lines by strips that continue them
    const Judge judge(raw, smooth, variance, leastZ);
    std::vector<LostLine> lines;
    for (const Strip& strip : strips) {
        if (stop.stop_requested())
            return {};
        const LostLine line = lineOf(strip);
        const auto same = std::ranges::find_if(
            lines, [&](const LostLine& other) { return isNear(other, line) || lengthened(other, line); });
        if (same == lines.end() && lines.size() < kMostLostLines && judge.isLostLine(strip))
            lines.push_back(line);
        else if (same != lines.end())
            if (const auto longer = lengthened(*same, line); longer && judge.isLostLine(strip))
                *same = *longer;
    }
    dropCovered(lines);
    return lines;
}

}  // namespace pdr::denoise
