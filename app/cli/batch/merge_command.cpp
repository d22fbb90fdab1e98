#include "app/cli/batch/merge_command.h"

#include <cstdio>
#include <new>

#include "app/cli/batch/joined_films.h"
#include "app/cli/failed.h"
#include "app/cli/render/image_run.h"
#include "app/cli/render/render_options.h"
#include "app/cli/run_command.h"
#include "render/base/errors.h"
#include "render/session/bias_measurements.h"

namespace pdr::app {
namespace {

/// Returns the film of `saved` as one that `device` has taken of the scene. Errors: the device's; it is of another
/// scene.
Result<TakenFilm> takenFrom(const SavedFilm& saved, const LoadedScene& work, Device& device) {
    const auto origin = filmOrigin(work.scene, device, saved.origin.samples, saved.origin.shares);
    if (!origin)
        return origin.error();
    if (const std::string difference = differenceOf(*origin, saved.origin); !difference.empty())
        return Error{"the films are from " + difference, "", "Give the options with which they were rendered."};
    const auto film = wholeFilm(saved, work.scene.revision);
    double seconds = 0;
    for (const FilmShare& share : saved.shares)
        seconds += share.seconds;
    const FilmStatus status = imageOf(*film, work.display.withDenoised(false)).status;
    // One machine measures the bias of what many have rendered: it takes the time for a share.
    return TakenFilm{film, {StopReason::samples, status, seconds}, kBiasTimeShare * seconds / saved.origin.shares};
}

int makeImages(const SavedFilm& saved, const RenderOptions& options, const Interrupt& interrupt) {
    const auto load = [&](const Progress& progress) { return loadScene(options.scene, progress); };
    const auto say = [&](RenderReport report) {
        report.device.details = std::to_string(saved.origin.shares) + " shares";
        std::fputs((options.json ? jsonText(report) : plainText(report)).c_str(), stdout);
    };
    const auto taken = [&](const LoadedScene& work, Device& device) { return takenFrom(saved, work, device); };
    return renderImages(options, {load, say, taken}, interrupt);
}

int merge(const MergeOptions& options, const Interrupt& interrupt) {
    try {
        const auto saved = joinedFilms(options.films);
        if (!saved)
            return failed(saved.error());
        if (!options.film.empty()) {
            if (auto written = writeFilm(*saved, options.film); !written)
                return failed(written.error());
            std::printf("%d of %d shares: %s\n", int(saved->shares.size()), saved->origin.shares, options.film.c_str());
            return 0;
        }
        if (auto complete = checkComplete(*saved); !complete)
            return failed(complete.error());
        return makeImages(*saved, options.render, interrupt);
    } catch (const std::bad_alloc&) {
        return failed(notEnoughMemory("for these films", "", "Take a larger machine for the merge."));
    }
}

}  // namespace

int runMerge(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("merge", mergeOptions(arguments), mergeHelp,
                      [&](const MergeOptions& options) { return merge(options, interrupt); });
}

}  // namespace pdr::app
