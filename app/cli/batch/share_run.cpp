#include "app/cli/batch/share_run.h"

#include <cstdio>
#include <utility>

#include "app/cli/batch/film_file.h"
#include "app/cli/failed.h"
#include "render/base/errors.h"
#include "render/session/batch_render.h"

namespace pdr::app {
namespace {

Error interrupted() {
    return {"interrupted: nothing was written", "", "Render this share again."};
}

/// Adds the samples of `tile`, of the scene that the device holds, to `share`. `before`, `here`: parts of the share
/// that were done before it, and that it is.
Result<void> takeTile(const Tile& tile, const LoadedScene& work, const Stops& stops, double before, double here,
                      Device& device, FilmShare& share, ProgressLine& line, const std::stop_token& stop) {
    const auto film = device.film(tile, work.scene.revision, work.scene.schedule);
    if (!film)
        return film.error();
    const auto show = [&](const BatchState& state) { line.show(before + here * state.fraction, "rendering"); };
    const auto result =
        BatchRender(**film, stops, work.display.withDenoised(false), WhenStopped::discard).run(stop, show);
    if (!result)
        return result.error();
    if (result->reason == StopReason::interrupted)
        return interrupted();
    const auto known = (*film)->film();
    if (!known)
        return known.error();
    addTile(share, **known);
    share.seconds += result->seconds;
    return {};
}

Result<void> renderAll(const RenderOptions& options, const LoadWork& load, const std::stop_token& stop) {
    ProgressLine line;
    const auto prepared = prepareWork(options, load, line, stop);
    if (!prepared)
        return prepared.error();
    const LoadedScene& work = prepared->loaded;
    Device& device = *prepared->device;
    const ivec2 size = work.scene.film;
    if (options.share->of > mostShares(size))
        return Error{"an image of " + std::to_string(size.x) + "x" + std::to_string(size.y) + " pixels has at most " +
                         std::to_string(mostShares(size)) + " shares",
                     "--share", "Take fewer."};
    const auto origin = filmOrigin(work.scene, device, *options.stops.samples, options.share->of);
    if (!origin)
        return origin.error();
    if (auto ok = device.upload(work.scene); !ok)
        return ok.error();
    SavedFilm saved{*origin, {{options.share->number, 0, {}, {}, {}}}};
    FilmShare& share = saved.shares.front();
    const std::vector<Tile> tiles = tilesOf(*options.share, size);
    const double all = double(pixelsIn(tiles));
    for (const Tile& tile : tiles)
        if (auto ok = takeTile(tile, work, options.stops, double(share.moments.size()) / all,
                               double(pixelsIn({tile})) / all, device, share, line, stop);
            !ok)
            return ok.error();
    line.finish();
    if (auto ok = writeFilm(saved, options.outputs.front()); !ok)
        return ok.error();
    std::printf("share %d of %d: %s in %s; %s\n", share.number, origin->shares, samplesText(origin->samples).c_str(),
                clockText(share.seconds).c_str(), options.outputs.front().c_str());
    return {};
}

}  // namespace

int renderShare(const RenderOptions& options, const LoadWork& load, const Interrupt& interrupt) {
    try {
        const auto done = renderAll(options, load, interrupt.token());
        if (done)
            return 0;
        return failed(done.error().kind == ErrorKind::cancelled ? interrupted() : done.error());
    } catch (const std::bad_alloc&) {
        return failed(notEnoughMemory("", options.scene.path.string(), "Take more shares, or a smaller volume."));
    }
}

}  // namespace pdr::app
