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

/// Returns the table column by column, each padded with its last entry.
std::vector<float> opticsTable(const PreparedScene& prepared, int stride) {
    const FlatTransferFunction& function = prepared.flat.transferFunction;
    std::vector<float> table(std::size_t(kOpticsColumns) * stride);
    for (int row = 0; row < stride; ++row) {
        const int i = std::min(row, function.pieceCount - 1);
        const OpacityPiece& piece = prepared.tables.pieces[i];
        const Material &from = prepared.tables.materials[2 * i], &to = prepared.tables.materials[2 * i + 1];
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

/// Sets the HU below and above which the curve is transparent.
void flattenClearRange(FlatOptics& optics, const PreparedScene& prepared) {
    const auto opaque = [&](int i) {
        return prepared.tables.pieces[i].opacity > 0 || prepared.tables.pieces[i].slope != 0;
    };
    const int count = int(prepared.tables.pieces.size());
    int first = 0, last = count - 1;
    while (first < count && !opaque(first))
        ++first;
    while (last >= 0 && !opaque(last))
        --last;
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    optics.clearUpTo = first == 0 ? -kInfinity : first < count ? prepared.tables.pieces[first].start : kInfinity;
    optics.clearFrom = last >= 0 ? prepared.tables.pieces[last].end : -kInfinity;
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
    const int stride = (flat.transferFunction.pieceCount + kLanes - 1) / kLanes * kLanes;
    prepared.optics = opticsTable(prepared, stride);
    vec3 brightest = glm::max(scene.environment.radiance, scene.environment.nadir.value_or(vec3(0)));
    if (prepared.environment)
        brightest *= prepared.environment->brightest;
    brightest = glm::max(brightest, scene.background.value_or(vec3(0)));
    for (const Material& material : prepared.tables.materials)
        brightest = glm::max(brightest, material.albedo + material.emission);
    const HuRange whole = prepared.volume->storedRange();
    const float tolerance = float(relativeTolerance(scene.toleranceLevels));
    flat.optics = {.model = flatModel(scene.model),
                   .table = prepared.optics.data(),
                   .stride = stride,
                   .rounding = kRoundingPerHu * float(std::max(-int(whole.lowest), int(whole.highest))),
                   .quadrature = float(kQuadratureShare) * tolerance,
                   .cutOff = float(1 - kQuadratureShare) * tolerance,
                   .brightest = brightest,
                   .windowLow = scene.window.lowHu,
                   .windowHigh = scene.window.highHu};
    flattenClearRange(flat.optics, prepared);
}

}  // namespace pdr
