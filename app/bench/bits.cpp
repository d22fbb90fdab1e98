#include <cstdio>
#include <cstring>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "render/device/device_list.h"
#include "render/scene/scene.h"
#include "render/tiles/reference_tiles.h"

namespace pdr::bench {

namespace {

/// FNV-1a hash. It must show differences, not resist an attacker.
class Digest {
  public:
    void add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i)
            value_ = (value_ ^ bytes[i]) * 0x100000001b3ull;
    }
    unsigned long long value() const { return value_; }

  private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

Result<Digest> imageDigest(Device& device, const Scene& scene, int samples) {
    const auto image = startFilm(device, scene);
    if (!image)
        return image.error();
    if (const Result<void> done = (*image)->accumulate(std::uint32_t(samples), {}); !done)
        return done.error();
    const auto film = (*image)->film();
    if (!film)
        return film.error();
    Digest digest;
    for (int y = 0; y < scene.film.y; ++y)
        for (int x = 0; x < scene.film.x; ++x) {
            const PixelEstimate pixel = (*film)->pixel(x, y);
            for (const dvec3& values : {pixel.mean, pixel.standardError, pixel.errorDraw})
                digest.add(&values, sizeof values);
        }
    return digest;
}

}  // namespace

int bits(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--device", "--threads", "--samples"});
    const auto threads = options ? options->number("--threads", 0, 0) : std::nullopt;
    const auto samples = options ? options->number("--samples", 70, 1) : std::nullopt;
    if (!threads || !samples)
        return 2;
    const Result<std::unique_ptr<Device>> device = openDevice(options->word("--device", "cpu"), *threads);
    if (!device)
        return fail(device.error());
    const Result<std::vector<std::byte>> tiles = referenceTiles(**device);
    if (!tiles)
        return fail(tiles.error());
    Digest digest;
    digest.add(tiles->data(), tiles->size());
    std::printf("reference tiles %016llx\n", digest.value());
    for (const std::string& file : options->files) {
        const Result<Scene> scene = loadScene(file);
        const Result<Digest> image = scene ? imageDigest(**device, *scene, *samples) : Result<Digest>(scene.error());
        if (!image)
            return fail(image.error());
        std::printf("%s %016llx\n", file.substr(file.find_last_of('/') + 1).c_str(), image->value());
    }
    return 0;
}

}  // namespace pdr::bench
