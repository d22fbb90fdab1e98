/// Renders one small image three times with the same device, and says of each whether it has the CPU's bits.
///   ptx_images [DEVICE]    prints "right" or an error's sentences for each, and first why "auto" is the CPU; on
///   standard
///                          error "preparing" and "prepared"; exit code 1: an image is wrong. DEVICE: "cuda" by default

#include <cstdio>
#include <memory>

#include "tests/ptx/small_scenes.h"

using namespace pdr;

namespace {

constexpr int kImages = 3;

/// Returns the film and an image that was fetched beside the next sample, which must agree with it.
Result<std::shared_ptr<const Film>> filmOf(Device& device, const Scene& scene) {
    const auto live = startFilm(device, scene);
    if (!live)
        return live.error();
    for (std::uint32_t n = 0; n < test::kSamples; ++n) {
        if (const auto done = (*live)->accumulate(1, {}); !done)
            return done.error();
        if (const auto done = (*live)->resolve({}); !done)
            return done.error();
        if (const auto image = (*live)->readback(); !image)
            return image.error();
    }
    return (*live)->film();
}

}  // namespace

int main(int argc, char** argv) {
    Scene scene = test::sceneOf(kSurface | kEnvironment | kBounces);
    const auto truth = filmOf(*makeCpuDevice(1), scene);
    const auto device = openDeviceToTheEnd(
        argc > 1 ? argv[1] : "cuda", 1,
        [](const Error& why) { std::printf("the CPU instead: %s\n", why.text().c_str()); },
        [](bool begins) { std::fputs(begins ? "preparing\n" : "prepared\n", stderr); });
    if (!device) {
        std::printf("%s\n", device.error().text().c_str());
        return 0;
    }
    bool isWrong = false;
    for (int n = 0; n < kImages; ++n) {
        scene.volume = std::make_shared<Volume>(*scene.volume);  // another one for the device
        ++scene.revision;
        const auto ours = filmOf(**device, scene);
        const bool isRight = ours && sameBits((*truth)->content(), (*ours)->content());
        isWrong = isWrong || (ours && !isRight);
        std::printf("%s\n", isRight ? "right" : ours ? "wrong" : ours.error().text().c_str());
    }
    return isWrong ? 1 : 0;
}
