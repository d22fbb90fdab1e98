#include "render/prepare/flatten_optics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/base/angles.h"
#include "render/kernel/bounds/mask_bound.h"
#include "render/kernel/quadrature/ray_maximum.h"
#include "render/scene/scene.h"

namespace pdr {

namespace {

/// Share of the tolerance for the sum along a ray; the rest is for what is omitted at its end.
constexpr double kQuadratureShare = 0.75;

/// Most that a tone curve (film/tone_curve.h) changes of 255 levels, in parts of 255, per relative error of a pixel's
/// channels, whatever their signs: keepsHue in bright greys, 0.6231, where a channel falls as another rises; perChannel
/// 0.2305.
constexpr double kMostPerRelativeError = 0.6232;

/// Error of interpolation in single precision: a few roundings of the largest HU.
constexpr float kRoundingPerHu = 0x1p-22f;

FlatModel flatModel(Model model) {
    switch (model) {
        case Model::absorption:
            return FlatModel::absorption;
        case Model::emission:
            return FlatModel::emission;
        case Model::emissionAbsorption:
            return FlatModel::emissionAbsorption;
        case Model::maximumIntensity:
            return FlatModel::maximumIntensity;
        case Model::singleScattering:
        case Model::multipleScattering:
            break;
    }
    return FlatModel::scattering;
}

int pieceCount(std::span<const FlatTransferFunction> curves) {
    int count = 0;
    for (const FlatTransferFunction& curve : curves)
        count += curve.pieceCount;
    return count;
}

/// Returns the table column by column, each padded with its last entry.
std::vector<float> opticsTable(std::span<const FlatTransferFunction> curves, int stride) {
    // tableLookup() reads the last curve's columns up to a multiple of kLanes behind its first piece.
    std::vector<float> table(std::size_t(kOpticsColumns) * stride + kLanes);
    const FlatTransferFunction* curve = curves.data();
    for (int row = 0; row < stride; ++row) {
        if (row == curve->firstPiece + curve->pieceCount && curve != &curves.back())
            ++curve;
        const FlatTransferFunction& function = *curve;
        const int i = std::min(row - function.firstPiece, function.pieceCount - 1);
        const OpacityPiece& piece = function.pieces[i];
        const Material &from = function.materials[2 * i], &to = function.materials[2 * i + 1];
        const bool inner = i > 0 && i + 1 < function.pieceCount;
        const auto set = [&](OpticsColumn column, int offset, float value) {
            table[(std::size_t(int(column)) + offset) * stride + row] = value;
        };
        // Compute in double, and never let the extinction fall below 0 within the piece.
        const double first = double(function.extinctionPerMm) * piece.opacity;
        const double rise =
            inner ? double(function.extinctionPerMm) * piece.slope * (double(piece.end) - piece.start) : 0;
        set(OpticsColumn::start, 0, i > 0 ? piece.start : -std::numeric_limits<float>::infinity());
        set(OpticsColumn::end, 0, piece.end);
        set(OpticsColumn::perHu, 0, inner ? float(1 / (double(piece.end) - piece.start)) : 0);
        set(OpticsColumn::extinction, 0, float(first));
        set(OpticsColumn::extinctionRise, 0, float(std::max(rise, -first)));
        for (int channel = 0; channel < 3; ++channel) {
            const float begin = from.albedo[channel] + from.emission[channel];
            set(OpticsColumn::source, channel, begin);
            set(OpticsColumn::sourceRise, channel, to.albedo[channel] + to.emission[channel] - begin);
        }
    }
    return table;
}

/// Lowers clearUpTo and raises clearFrom to the HU below and above which a curve is transparent.
void includeInClearRange(FlatOptics& optics, const FlatTransferFunction& curve) {
    const auto opaque = [&](int i) { return curve.pieces[i].opacity > 0 || curve.pieces[i].slope != 0; };
    const int count = curve.pieceCount;
    int first = 0, last = count - 1;
    while (first < count && !opaque(first))
        ++first;
    while (last >= 0 && !opaque(last))
        --last;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float upTo = first == 0 ? -kInfinity : first < count ? curve.pieces[first].start : kInfinity;
    optics.clearUpTo = std::min(optics.clearUpTo, upTo);
    optics.clearFrom = std::max(optics.clearFrom, last >= 0 ? curve.pieces[last].end : -kInfinity);
}

}  // namespace

double relativeTolerance(double levels) {
    return -expMinusOne(-levels / (255 * kMostPerRelativeError));
}

Majorants highestHu(const CellRanges& ranges, ivec3 volumeSize, const FlatMask& mask) {
    Majorants highest;
    const ivec3 size = ranges.fineSize(), coarseSize = ranges.coarseSize();
    highest.fine.resize(ranges.cells().size());
    highest.coarse.resize(std::size_t(coarseSize.x) * coarseSize.y * coarseSize.z, 0.0f);
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const std::size_t at = (std::size_t(k) * size.y + j) * size.x + i;
                const HuRange cell = ranges.cells()[at];
                const float value = highestHuBound(cell, mask, volumeSize, {i, j, k});
                float& coarse =
                    highest
                        .coarse[(std::size_t(k / kFinePerCoarse) * coarseSize.y + j / kFinePerCoarse) * coarseSize.x +
                                i / kFinePerCoarse];
                highest.fine[at] = value;
                coarse = std::max(coarse, value);
            }
    highest.occupiedLow = vec3(-0.5f);
    highest.occupiedHigh = vec3(volumeSize) - 0.5f;
    return highest;
}

void flattenOptics(PreparedScene& prepared, const Scene& scene) {
    FlatScene& flat = prepared.flat;
    const std::span<const FlatTransferFunction> curves = curvesOf(prepared);
    const int stride = (pieceCount(curves) + kLanes - 1) / kLanes * kLanes;
    prepared.optics = opticsTable(curves, stride);
    vec3 brightest = glm::max(scene.environment.radiance, scene.environment.nadir.value_or(vec3(0)));
    if (prepared.environment)
        brightest *= prepared.environment->brightest;
    brightest = glm::max(brightest, scene.background.value_or(vec3(0)));
    for (const FlatTransferFunction& curve : curves)
        for (int i = 0; i < 2 * curve.pieceCount; ++i)
            brightest = glm::max(brightest, curve.materials[i].albedo + curve.materials[i].emission);
    const HuRange whole = prepared.volume->storedRange();
    const float tolerance = float(relativeTolerance(scene.toleranceLevels));
    flat.optics = {.model = flatModel(scene.model),
                   .table = prepared.optics.data(),
                   .stride = stride,
                   .clearUpTo = std::numeric_limits<float>::infinity(),
                   .clearFrom = -std::numeric_limits<float>::infinity(),
                   .rounding = kRoundingPerHu * float(std::max(-int(whole.lowest), int(whole.highest))),
                   .quadrature = float(kQuadratureShare) * tolerance,
                   .cutOff = float(1 - kQuadratureShare) * tolerance,
                   .brightest = brightest,
                   .windowLow = scene.window.lowHu,
                   .windowHigh = scene.window.highHu};
    for (const FlatTransferFunction& curve : curves)
        includeInClearRange(flat.optics, curve);
}

}  // namespace pdr
