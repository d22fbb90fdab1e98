#pragma once
/// What the CUDA runtime's errors mean for the user.

#include <cuda_runtime_api.h>

#include <string>

#include "render/base/result.h"

namespace pdr {

/// Returns the error of a call that ended with `status`. `doing`: what was tried, "a launch".
Error cudaFailure(cudaError_t status, const std::string& gpu, const char* doing);

}  // namespace pdr
