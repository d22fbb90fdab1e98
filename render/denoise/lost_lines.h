#pragma once
/// Finds fine lines that denoising removed though the noisy image shows them: what it removed adds up, along each, to
/// more than noise can.
///   line        darker, or brighter, than both of its sides; an edge that denoising has blurred is none
///   lost        less than half of its contrast is left, and the lost contrast would be visible
///   not found   lines that are shorter than 45 pixels, bend much more than a strip is wide, or lie within 4 pixels of
///               an edge

#include "render/denoise/plane.h"

namespace pdr::denoise {

struct LostLine {
    vec2 begin{0.0f}, end{0.0f};  ///< pixels from the image's upper left corner; (0.5, 0.5): middle of the first one
    bool darker = false;          ///< darker than its sides
};

inline constexpr std::size_t kMostLostLines = 200;

/// Returns the lines, the clearest first, kMostLostLines at most; at most one image in 20 has a false one. All planes
/// are luminances; `variance`: of the noise in `raw`, independent from pixel to pixel. None after a stop request.
std::vector<LostLine> lostLines(const Plane& raw, const Plane& smooth, const Plane& variance,
                                const std::stop_token& stop = {});

}  // namespace pdr::denoise
