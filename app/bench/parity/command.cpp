#include <algorithm>
#include <cstdio>
#include <cstring>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "app/bench/parity/scenes.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace {

constexpr std::uint32_t kSamples = 16;

using Shot = Result<std::shared_ptr<const Film>>;

Shot shot(Device& device, const Scene& scene, std::uint32_t samples) {
    const auto live = startFilm(device, scene);
    if (!live)
        return live.error();
    if (const auto accumulated = (*live)->accumulate(samples, {}); !accumulated)
        return accumulated.error();
    return (*live)->film();
}

bool identical(const Film& a, const Film& b) {
    return sameBits(a.content(), b.content());
}

/// Prints the table line by line, and records whether all checks hold.
class Verdicts {
  public:
    void line(const std::string& what, bool holds, const std::string& figures = "") {
        std::printf("%-44s %-6s %s\n", what.c_str(), holds ? "holds" : "FAILS", figures.c_str());
        std::fflush(stdout);
        all_ = all_ && holds;
    }
    void failed(const std::string& what, const Error& error) { line(what, false, error.text()); }
    bool all() const { return all_; }

  private:
    bool all_ = true;
};

/// Compares the same samples on both devices, bit by bit. If they differ, prints how many pixels agree and how far off
/// the mean is.
void compareWithCpu(Verdicts& verdicts, Device& device, Device& cpu, const ParityScene& one) {
    const Shot theirs = shot(cpu, one.scene, kSamples), ours = shot(device, one.scene, kSamples);
    if (!theirs || !ours)
        return verdicts.failed(one.name, theirs ? ours.error() : theirs.error());
    const double truth = (*theirs)->status().meanLuminance;
    if (identical(**theirs, **ours))
        return verdicts.line(one.name, truth > 0);
    const ivec2 size = one.scene.film;
    int agree = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            agree += (*theirs)->pixel(x, y).mean == (*ours)->pixel(x, y).mean;
    char figures[120];
    std::snprintf(figures, sizeof figures, "%.3f %% of the pixels agree, mean %+.1e",
                  100 * double(agree) / (double(size.x) * size.y), (*ours)->status().meanLuminance / truth - 1);
    verdicts.line(one.name, false, figures);
}

/// Renders 100 samples tile by tile, with some tiles far ahead of others on the way, and compares with `whole`.
bool renderedByTiles(Device& device, const Scene& scene, const Film& whole) {
    const auto live = startFilm(device, scene);
    if (!live)
        return false;
    for (const std::uint32_t n : {70, 30})
        for (int y = 0; y < scene.film.y; y += 3 * kFilmCell)
            if (!(*live)->accumulate({0, y, scene.film.x, std::min(3 * kFilmCell, scene.film.y - y)}, n, {}))
                return false;
    const Shot tiled = (*live)->film();
    return tiled && identical(whole, **tiled);
}

/// Checks that a device gives the same image however the work is divided: n samples at a time, by tiles, and in
/// Exposure Render's schedule.
void compareWays(Verdicts& verdicts, Device& device, const Scene& scene) {
    const Shot whole = shot(device, scene, 100);
    if (!whole)
        return verdicts.failed("one image", whole.error());
    Scene kroes = scene;
    kroes.schedule = {.kind = Schedule::Kind::kroes, .redundant = true, .filter = false, .runningMean = false};
    const Shot old = shot(device, kroes, 100);
    verdicts.line("Exposure Render's schedule, bit by bit", old && identical(**whole, **old));
    verdicts.line("by tiles, bit by bit", renderedByTiles(device, scene, **whole));
}

/// Checks that images arrive whole if they are transferred while the next samples are taken: readback() checks both of
/// their ends.
void carryImages(Verdicts& verdicts, Device& device, const Scene& scene) {
    const auto live = startFilm(device, scene);
    if (!live)
        return verdicts.failed("1000 images arrive whole", live.error());
    Result<void> done;
    int waiting = 0;
    std::uint64_t arrived = 0;
    for (int i = 0; i < 1000 && done; ++i) {
        done = (*live)->accumulate(1, {});
        done = done ? (*live)->resolve({}) : done;
        for (++waiting; done && waiting >= (*live)->maxInFlight(); --waiting) {
            const auto image = (*live)->readback();
            done = image ? Result<void>() : image.error();
            arrived += image && image->status.samplesPerPixel == arrived + 1;
        }
    }
    verdicts.line("1000 images arrive whole, in order", done && arrived + std::uint64_t(waiting) == 1000,
                  done ? "" : done.error().text());
}

/// Checks that as much memory is free after 1000 loads and unloads as before.
void returnMemory(Verdicts& verdicts, Device& device, Scene scene) {
    const Scene other = scene;
    scene.volume = std::make_shared<Volume>(*scene.volume);  // a different volume for the device
    scene.film = {64, 64};
    const auto load = [&](int i) { return bool(shot(device, i % 2 ? scene : other, 1)); };
    bool loaded = load(0) && load(1) && load(0);
    const std::size_t before = device.info().freeBytes;
    for (int i = 1; i <= 1000; ++i)
        loaded = loaded && load(i);
    const std::size_t after = device.info().freeBytes;
    char figures[80];
    std::snprintf(figures, sizeof figures, "free before %zu, after %zu bytes", before, after);
    verdicts.line("memory returns after 1000 loads", loaded && before == after, figures);
}

}  // namespace

int parity(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--device"}, {"--quick"});
    if (!options)
        return 2;
    const std::vector<ParityScene> scenes = parityScenes();
    for (const std::string& name : options->files)
        if (std::ranges::count(scenes, name, &ParityScene::name) == 0)
            return fail({"there is no such scene", name, "Without a name all are compared; the table names them."});
    const auto device = openDevice(options->word("--device", "cuda"));
    if (!device)
        return fail(device.error());
    const DeviceInfo info = (*device)->info();
    std::printf("%s (%s) against the CPU: %u samples a pixel, bit by bit\n", info.name.c_str(), info.details.c_str(),
                kSamples);
    const auto cpu = makeCpuDevice();
    Verdicts verdicts;
    for (const ParityScene& one : scenes)
        if (options->files.empty() || std::ranges::count(options->files, one.name) > 0)
            compareWithCpu(verdicts, **device, *cpu, one);
    if (!options->named.contains("--quick")) {
        compareWays(verdicts, **device, scenes[3].scene);
        carryImages(verdicts, **device, scenes[3].scene);
        returnMemory(verdicts, **device, scenes[3].scene);
    }
    return verdicts.all() ? 0 : 1;
}

}  // namespace pdr::bench
