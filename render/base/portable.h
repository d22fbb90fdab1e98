#pragma once
/// The one file that knows which compiler reads it. Every kernel header includes it first.
///   PDR_HD   marks a function that runs on the host and, where nvcc compiles it, on the device.

#if defined(__CUDACC__)
#include <cuda.h>  // before GLM, which asks for CUDA_VERSION
#define GLM_FORCE_CUDA
#define PDR_HD __host__ __device__
#else
#define PDR_HD
#endif

#define GLM_FORCE_XYZW_ONLY
#include <glm/glm.hpp>

namespace pdr {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;
using glm::ivec2;
using glm::ivec3;
using glm::mat3;
using glm::vec2;
using glm::vec3;

inline constexpr float kPi = 3.14159265358979323846f;

}  // namespace pdr
