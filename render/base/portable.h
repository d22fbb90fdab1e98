#pragma once
/// Differences between compilers, which only this file knows. Every kernel header includes it first.
///   PDR_HD         marks a function that runs on the host and, where nvcc compiles it, on the device
///   PDR_HD_INLINE  as PDR_HD and always inlined: for the few inner loops whose state must stay in registers

#if defined(__CUDACC__)
#include <cuda.h>  // before GLM, which asks for CUDA_VERSION
#define GLM_FORCE_CUDA
#define PDR_HD __host__ __device__
#define PDR_HD_INLINE __host__ __device__ __forceinline__
#else
#define PDR_HD
#define PDR_HD_INLINE inline __attribute__((always_inline))
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

/// Number of paths that the CPU traces in SIMD lanes: as many as fit its widest vector registers.
#if defined(__AVX512F__) && defined(__AVX512DQ__)
inline constexpr int kLanes = 16;
#elif defined(__AVX2__)
inline constexpr int kLanes = 8;
#else
inline constexpr int kLanes = 4;
#endif

inline constexpr float kPi = 3.14159265358979323846f;

}  // namespace pdr
