#pragma once
/// The stages of an iteration of Exposure Render (Kroes, Post & Botha 2012), as GPU programs; see kroes_accumulator.h.
/// Index i is the pixel y * width + x.

#include <cstdint>

#include "render/device/baseline/frame_sampler.h"
#include "render/film/levels.h"
#include "render/film/moments.h"
#include "render/kernel/baseline/march.h"
#include "render/kernel/pixel.h"
#include "render/kernel/transport/camera_ray.h"

namespace pdr::kroes {

/// Weights of the filter along one axis; centre and both neighbours sum up to 1. The filter leaves the fraction
/// (centre^2 + 2 beside^2)^2 = 0.117 of the noise's variance.
inline constexpr float kCentreWeight = 0.4110f, kBesideWeight = 0.2945f;

/// Filters along one axis. Pixels beyond the border and pixels that do not count are left out; the weights of the rest
/// are scaled to sum up to 1.
struct Blur {
    const SampledPixel* from;
    SampledPixel* to;
    ivec2 size;
    int axis;  ///< 0: along x, 1: along y

    PDR_HD void operator()(std::int64_t i) const {
        const ivec2 pixel(int(i % size.x), int(i / size.x));
        vec3 sum(0);
        float weights = 0;
        for (int offset = -1; offset <= 1; ++offset) {
            ivec2 other = pixel;
            other[axis] += offset;
            if (other[axis] < 0 || other[axis] >= size[axis])
                continue;
            const SampledPixel& beside = from[std::int64_t(other.y) * size.x + other.x];
            const float weight = (offset == 0 ? kCentreWeight : kBesideWeight) * float(beside.counts);
            sum += beside.radiance * weight;
            weights += weight;
        }
        to[i] = weights > 0 ? SampledPixel{sum / weights, 1, from[i].seen} : SampledPixel{vec3(0), 0, from[i].seen};
    }
};

/// Updates a running mean in single precision: A += (x - A) / max(N, 1), N = iterations done; the second iteration
/// replaces the first.
struct RunningMean {
    const SampledPixel* frame;
    SampledPixel* mean;
    std::uint64_t done;

    PDR_HD void operator()(std::int64_t i) const {
        mean[i].seen |= frame[i].seen;
        if (frame[i].counts == 0)
            return;
        const float divisor = glm::max(float(done), 1.0f);
        mean[i].radiance += (frame[i].radiance - mean[i].radiance) / divisor;
        mean[i].counts = 1;
    }
};

/// Adds a frame to the film's own sums, without a running mean.
struct AddToBlock {
    const SampledPixel* frame;
    PixelSums* block;
    std::uint64_t sample;

    PDR_HD void operator()(std::int64_t i) const {
        block[i].seen |= frame[i].seen;
        if (frame[i].counts > 0)
            addSample(block[i], frame[i].radiance, sample);
    }
};

struct MergeBlock {
    PixelSums* block;
    Moments* moments;

    PDR_HD void operator()(std::int64_t i) const {
        moments[i] = merged(moments[i], block[i]);
        block[i] = nextBlock(block[i]);
    }
};

/// The data that tone mapping needs besides the mean.
struct Levels {
    const double* thresholds;
    double exposure;
    std::uint8_t* rgba;

    PDR_HD void show(std::int64_t i, dvec3 mean) const {
        for (int channel = 0; channel < 3; ++channel)
            rgba[4 * i + channel] = levelOf(thresholds, mean[channel], exposure);
        rgba[4 * i + 3] = 255;
    }
};

struct ShowMean {
    const SampledPixel* mean;
    Levels levels;

    PDR_HD void operator()(std::int64_t i) const { levels.show(i, dvec3(mean[i].radiance)); }
};

struct ShowSums {
    const Moments* moments;
    const PixelSums* block;
    Levels levels;

    PDR_HD void operator()(std::int64_t i) const { levels.show(i, merged(moments[i], block[i]).mean); }
};

/// Marches with one thread along the middle of the view until there is opacity. Result: distance from the box [mm], or
/// -1.
struct Autofocus {
    FlatScene scene;
    float* distance;

    PDR_HD void operator()(std::int64_t) const {
        const PathSegment segment =
            generateCameraRay(scene, vec2(scene.camera.film) * 0.5f, vec2(0), vec2(0, kFarAway));
        const float step = marchStep(scene.volume, kExposureRenderStep);
        *distance = -1;
        for (int i = 0; float(i) * step < segment.ray.length; ++i) {
            const vec3 place = segment.ray.origin + segment.ray.direction * (float(i) * step);
            if (!(extinction(scene, place) > 0))
                continue;
            *distance = float(i) * step;
            return;
        }
    }
};

}  // namespace pdr::kroes
