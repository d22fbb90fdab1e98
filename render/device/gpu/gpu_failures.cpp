#include "render/device/gpu/gpu_failures.h"

#include <utility>

#include "render/base/errors.h"

namespace pdr {

Error gpuTooOld(std::string gpu, const std::string& capability, const std::string& oldest) {
    return {phrase("the GPU is too old for this program: it is of compute capability %1, %2 or later is needed",
                   capability, oldest),
            std::move(gpu), phrase("Only the CPU or a newer GPU can render.")};
}

Error driverTooOld(std::string gpu, const std::string& known, const std::string& needed) {
    return {phrase("the driver is too old: it knows CUDA %1, %2 is needed", known, needed), std::move(gpu),
            phrase("Install a newer driver; until then only the CPU can render.")};
}

Error driverMixed(std::string gpu) {
    return {phrase("parts of the driver are of different versions: it was updated while the computer ran"),
            std::move(gpu), phrase("Restart the computer; until then only the CPU can render.")};
}

Error gpuCodeMissing(std::string gpu, const std::string& detail) {
    return {phrase("neither this program nor the driver has code for the GPU (%1)", detail), std::move(gpu),
            phrase("Install a newer driver, or a build of this program for this GPU; until then only the CPU can "
                   "render.")};
}

Error gpuInUse(std::string gpu) {
    return {phrase("another program has the GPU to itself, or nobody may compute on it"), std::move(gpu),
            phrase("Close that program, or ask who looks after the computer; until then only the CPU can render.")};
}

Error gpuMemoryTaken(std::string gpu, std::size_t free) {
    return {phrase("the memory of the GPU is taken: %1 are free", bytesText(free)), std::move(gpu),
            phrase("Close programs that use the GPU, make the image smaller, or render on the CPU."),
            ErrorKind::memory};
}

Error gpuTimedOut(std::string gpu) {
    return {phrase("the driver stopped the GPU, since the display had to wait for it"), std::move(gpu),
            phrase("Start the program again to use the GPU, with a smaller image, or use one that has no display."),
            ErrorKind::deviceLost};
}

Error gpuMemoryDamaged(std::string gpu) {
    return {phrase("the memory of the GPU has lost bits"), std::move(gpu),
            phrase("Restart the computer to use the GPU; if it happens again, have the GPU replaced."),
            ErrorKind::deviceLost};
}

Error gpuLost(std::string gpu, const std::string& detail) {
    return {phrase("the GPU was lost (%1)", detail), std::move(gpu),
            phrase("Start the program again to use the GPU; if it is lost again, install a newer driver or restart "
                   "the computer."),
            ErrorKind::deviceLost};
}

Error gpuFailed(std::string gpu, const std::string& detail) {
    return {phrase("the GPU failed (%1)", detail), std::move(gpu),
            phrase("Try again; if it fails again, start the program again, or render on the CPU.")};
}

}  // namespace pdr
