#pragma once
/// Errors of GPUs: each cause has a sentence of its own, and says what its user can do. A program that goes on on the
/// CPU repeats both, so no hint only says to render there.

#include <cstddef>
#include <string>

#include "render/base/result.h"

namespace pdr {

/// The GPU is older than all that the program is compiled for. `capability`, `oldest`: "7.0", "7.5".
Error gpuTooOld(std::string gpu, const std::string& capability, const std::string& oldest);
/// The driver is older than the program's runtime. `known`, `needed`: their versions of CUDA, "12.8" and "13.0".
Error driverTooOld(std::string gpu, const std::string& known, const std::string& needed);
/// Parts of the driver are of different versions, as after an update until the computer starts again.
Error driverMixed(std::string gpu);
/// Neither the program nor the driver has code for a kernel. `detail`: the driver's words.
Error gpuCodeMissing(std::string gpu, const std::string& detail);
/// Another program has the GPU to itself, or nobody may compute on it.
Error gpuInUse(std::string gpu);
/// The driver has no memory left for what a launch needs, such as code or a stream. `free`: bytes.
Error gpuMemoryTaken(std::string gpu, std::size_t free);
/// The driver ended a launch for which a display had to wait.
Error gpuTimedOut(std::string gpu);
/// The GPU's memory has lost bits, which it cannot restore.
Error gpuMemoryDamaged(std::string gpu);
/// No call will succeed any more before the program starts again. `detail`: what was tried, and the driver's words.
Error gpuLost(std::string gpu, const std::string& detail);
/// A call failed, and a later one may succeed. `detail`: what was tried, and the driver's words.
Error gpuFailed(std::string gpu, const std::string& detail);

}  // namespace pdr
