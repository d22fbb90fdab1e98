#pragma once
/// Fine lines that smoothing took away though the noisy picture knows of them: what it took adds up, along each, to
/// more than noise may.
///   line        darker, or brighter, than both of its sides; an edge that smoothing has blurred is none
///   lost        less than half of it is left, and what is gone would be seen
///   not found   what is shorter than 45 pixels, much more bent than a strip is wide, or within 4 pixels of an edge

#include "render/denoise/plane.h"

namespace pdr::denoise {

struct LostLine {
    vec2 begin{0.0f}, end{0.0f};  ///< pixels from the picture's upper left corner; (0.5, 0.5): middle of the first one
    bool darker = false;          ///< than its sides
};

inline constexpr std::size_t kMostLostLines = 200;

/// The clearest first, kMostLostLines at most; a false one in one of 20 pictures at most. All are luminances;
/// `variance`: of the noise in `raw`, independent from pixel to pixel. None after a stop request.
std::vector<LostLine> lostLines(const Plane& raw, const Plane& smooth, const Plane& variance,
                                const std::stop_token& stop = {});

}  // namespace pdr::denoise
