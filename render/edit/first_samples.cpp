#include "render/edit/first_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "render/denoise/resampled.h"

namespace pdr {
namespace {

/// An upper bound on radiance: anything brighter is far beyond white. Its square is still finite.
constexpr double kBrightest = 1e15;

/// Pixels of a half of the first sample that share their noise: a sample counts for its own pixel and for a quarter of
/// each around it, by which the variance of a sum of pixels is 2 of a sample's, and their mean variance 5 / 8.
constexpr float kChessboardAlike = 3.2f;

/// Returns the radius of the box that smooths images of `mark` samples: 1, 4, 16, 64.
int radiusOf(std::uint64_t mark) {
    return mark <= 1 ? 5 : mark <= 4 ? 3 : mark <= 16 ? 2 : 1;
}

/// Returns the same for a change of light, which has less noise of its own than features in its way.
int radiusForChange(std::uint64_t mark) {
    return mark <= 1 ? 8 : mark <= 4 ? 4 : radiusOf(mark);
}

denoise::Colours smoothed(const denoise::Colours& image, int radius) {
    denoise::Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = denoise::boxed(denoise::boxed(image[c], radius), radius);
    return out;
}

void set(denoise::Colours& colours, ivec2 at, dvec3 radiance) {
    for (int c = 0; c < 3; ++c)
        colours[c].row(at.y)[at.x] = float(std::min(radiance[c], kBrightest));
}

void mirror(denoise::Colours& colours) {
    for (denoise::Plane& plane : colours)
        plane.mirror();
}

/// Returns the pixels of one colour of a chessboard, and between them the mean of the four around each.
denoise::Plane chessboard(const denoise::Plane& plane, int colour) {
    const ivec2 size = plane.size();
    denoise::Plane out(size);
    denoise::eachBand(size.y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y) {
            // Beyond an edge lies a copy of the edge, which is of the other colour
            const float *above = plane.row(y > 0 ? y - 1 : 1), *below = plane.row(y + 1 < size.y ? y + 1 : size.y - 2);
            const float* row = plane.row(y);
            for (int x = 0; x < size.x; ++x) {
                const float across = row[x > 0 ? x - 1 : 1] + row[x + 1 < size.x ? x + 1 : size.x - 2];
                out.row(y)[x] = (x + y) % 2 == colour ? row[x] : (above[x] + below[x] + across) / 4;
            }
        }
    });
    out.mirror();
    return out;
}

HalfImages onChessboard(const denoise::Colours& image) {
    HalfImages halves;
    for (std::size_t c = 0; c < 3; ++c) {
        halves.even[c] = chessboard(image[c], 0);
        halves.odd[c] = chessboard(image[c], 1);
    }
    return halves;
}

}  // namespace

HalfImages halfImagesOf(const Film& film) {
    HalfImages halves{denoise::coloursOf(film.size()), denoise::coloursOf(film.size())};
    const std::size_t width = std::size_t(film.size().x);
    film.each([&](std::size_t pixel, const Moments& known) {
        const ivec2 at(int(pixel % width), int(pixel / width));
        const HalfMeans means = halvesOf(known);
        set(halves.even, at, means.even);
        set(halves.odd, at, means.odd);
    });
    mirror(halves.even);
    mirror(halves.odd);
    return film.samplesPerPixel() < 2 ? onChessboard(halves.even) : halves;
}

HalfImages smoothed(const HalfImages& halves, std::uint64_t mark) {
    return {smoothed(halves.even, radiusOf(mark)), smoothed(halves.odd, radiusOf(mark))};
}

HalfImages smoothedForChange(const HalfImages& halves, std::uint64_t mark) {
    return {smoothed(halves.even, radiusForChange(mark)), smoothed(halves.odd, radiusForChange(mark))};
}

float pixelsAlike(std::uint64_t mark) {
    return mark > 1 ? 1 : kChessboardAlike;
}

denoise::Colours meanOf(const denoise::Colours& a, const denoise::Colours& b) {
    denoise::Colours mean;
    for (std::size_t c = 0; c < 3; ++c)
        mean[c] = denoise::combined([](float x, float y) { return (x + y) / 2; }, a[c], b[c]);
    return mean;
}

bool FirstSamples::isMark(std::uint64_t samples) {
    return std::ranges::find(kMarks, samples) != kMarks.end();
}

std::uint64_t FirstSamples::leftToMark(std::uint64_t samples) {
    const auto next = std::ranges::upper_bound(kMarks, samples);
    return next == kMarks.end() ? std::numeric_limits<std::uint64_t>::max() : *next - samples;
}

void FirstSamples::keep(const Film& film) {
    const SampleCounts counts = film.samples();
    const auto mark = std::ranges::find(kMarks, counts.least);
    if (mark != kMarks.end() && counts.least == counts.most)
        kept_[std::size_t(mark - kMarks.begin())] = std::make_shared<const HalfImages>(halfImagesOf(film));
}

void FirstSamples::keepUnshadowed(const denoise::Guide& guide) {
    denoise::Colours light;
    for (std::size_t c = 0; c < 3; ++c)
        light[c] = guide.finer > 1 ? denoise::reduced(guide.radiance[c], guide.depth.size() / guide.finer)
                                   : denoise::boxed(guide.radiance[c], 1);  // its edges are jagged
    unshadowed_ = std::make_shared<const denoise::Colours>(std::move(light));
}

std::shared_ptr<const HalfImages> FirstSamples::at(std::uint64_t mark) const {
    const auto found = std::ranges::find(kMarks, mark);
    return found == kMarks.end() ? nullptr : kept_[std::size_t(found - kMarks.begin())];
}

std::size_t FirstSamples::bytes() const {
    std::size_t sum = unshadowed_ ? denoise::bytesOf(*unshadowed_) : 0;
    for (const auto& halves : kept_)
        sum += halves ? denoise::bytesOf(halves->even) + denoise::bytesOf(halves->odd) : 0;
    return sum;
}

std::uint64_t FirstSamples::lastShared(const FirstSamples& other, std::uint64_t samples) const {
    std::uint64_t last = 0;
    for (const std::uint64_t mark : kMarks)
        if (mark <= samples && at(mark) && other.at(mark))
            last = mark;
    return last;
}

}  // namespace pdr
