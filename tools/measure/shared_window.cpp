/// Renders an image as the window does, frame by frame, with the help of a render node.
///   shared_window FOLDER|SCENE NODE [--size N] [--samples N] [--threads N] [--edits N] [--faster N]
/// NODE is the address of a node on this machine, which takes all samples. When it is ready the view is shown once
/// more, so that all its frames are shared: denoised, at the pace that the window chooses, until a pixel has N samples.
/// Then the opacity of all tissue is edited so often, each time until a pixel has N samples.
/// --faster: by a clock that is so many times slower, as if as many nodes shared the work.
/// Prints how many frames there were, and after how many samples. tools/measure/node_bytes.py counts what is sent
/// meanwhile.

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <memory>
#include <mutex>
#include <thread>

#include "app/bench/options.h"
#include "app/cli/scene/scene_input.h"
#include "app/coordinator/new_pool.h"
#include "app/coordinator/render_nodes.h"
#include "render/device/device.h"
#include "render/session/session.h"
#include "render/tiles/reference_tiles.h"
#include "render/tiles/shared_device.h"

namespace pdr {
namespace {

/// Records the frames of one scene.
class Frames {
  public:
    void take(const Frame& frame) {
        const std::lock_guard lock(mutex_);
        if (!frame.error.empty())
            error_ = frame.error;
        if (frame.revision == revision_ && !frame.rgba.empty() && !frame.coarse)
            samples_.push_back(frame.status.samplesPerPixel);
        changed_.notify_all();
    }
    void begin(std::uint64_t revision) {
        const std::lock_guard lock(mutex_);
        revision_ = revision;
        samples_.clear();
    }
    /// Waits for a frame of so many samples. Returns the samples of all frames; none after an error.
    std::vector<std::uint64_t> await(std::uint64_t samples) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !error_.empty() || (!samples_.empty() && samples_.back() >= samples); });
        return error_.empty() ? samples_ : std::vector<std::uint64_t>();
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::uint64_t revision_ = 0;
    std::vector<std::uint64_t> samples_;
    Text error_;
};

void awaitNode(const WorkerPool& pool) {
    const auto isReady = [](const WorkerStatus& worker) { return worker.state == WorkerState::ready; };
    while (!std::ranges::any_of(pool.workers(), isReady))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

struct Wanted {
    int threads;
    std::uint64_t samples, edits;
    double faster;
};

/// Returns a clock by which all is so many times faster.
SessionClock clockOf(double faster) {
    return [faster] { return steadySeconds() / faster; };
}

/// Waits for an image, and prints after how many samples it was shown. False: it failed.
bool awaitImage(Frames& frames, std::uint64_t samples) {
    const std::vector<std::uint64_t> all = frames.await(samples);
    std::printf("%zu frames, of", all.size());
    for (std::size_t i = 0; i < all.size(); i += std::max<std::size_t>(all.size() / 16, 1))
        std::printf(" %llu", static_cast<unsigned long long>(all[i]));
    std::printf(" ... samples\n");
    return !all.empty();
}

int show(const app::LoadedScene& loaded, const QString& address, const Wanted& wanted) {
    const auto [threads, samples, edits, faster] = wanted;
    const auto pool = nodes::newPool();
    pool->setOwnHelps(false);
    nodes::RenderNodes nodes(pool, *referenceTiles(*makeCpuDevice(threads)));
    if (const auto added = nodes.add(address); !added) {
        std::fprintf(stderr, "%s\n", added.error().text().c_str());
        return 1;
    }
    Frames frames;
    Session session(
        shareDevice(makeCpuDevice(threads), pool),
        [&](const std::shared_ptr<const Frame>& frame) { frames.take(*frame); }, {}, clockOf(faster));
    session.setPace({.automatic = true});
    session.setStop({.levels = 1e-9, .samples = samples});
    session.setDisplay(loaded.display.withDenoised(true));
    Scene scene = loaded.scene;
    const auto submit = [&] {
        ++scene.revision;
        frames.begin(scene.revision);
        session.submit(scene, false);
    };
    submit();
    awaitNode(*pool);
    ++scene.seed;
    submit();
    bool isShown = awaitImage(frames, samples);
    for (std::uint64_t edit = 0; isShown && edit < edits; ++edit) {
        for (TransferNode& node : scene.transferFunction.nodes)
            node.opacity *= 0.98f;
        submit();
        isShown = awaitImage(frames, samples);
    }
    return isShown ? 0 : 1;
}

}  // namespace
}  // namespace pdr

int main(int count, char** words) {
    using namespace pdr;
    QCoreApplication application(count, words);
    const auto options = bench::Options::read({words + 1, words + count},
                                              {"--size", "--samples", "--threads", "--edits", "--faster"}, {});
    const auto size = options ? options->number("--size", 256, 16) : std::nullopt;
    const auto samples = options ? options->number("--samples", 256, 1) : std::nullopt;
    const auto threads = options ? options->number("--threads", 1, 1) : std::nullopt;
    const auto edits = options ? options->number("--edits", 0, 0) : std::nullopt;
    const auto faster = options ? options->number("--faster", 1, 1) : std::nullopt;
    if (!size || !samples || !threads || !edits || !faster || options->files.size() != 2) {
        std::fprintf(stderr,
                     "usage: shared_window FOLDER|SCENE NODE [--size N] [--samples N] [--threads N] [--edits N] "
                     "[--faster N]\n");
        return 2;
    }
    const auto loaded = app::loadScene({.path = options->files[0], .size = ivec2(*size)}, noProgress);
    if (!loaded) {
        std::fprintf(stderr, "%s\n", loaded.error().what.c_str());
        return 1;
    }
    return show(*loaded, QString::fromStdString(options->files[1]),
                {int(*threads), std::uint64_t(*samples), std::uint64_t(*edits), double(*faster)});
}
