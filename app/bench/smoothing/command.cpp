#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "app/bench/paper/text_table.h"
#include "app/bench/smoothing/measurement.h"
#include "render/scene/scene.h"

namespace pdr::bench {
namespace {

using paper::digits;

struct Plan {
    int samples, reference, rounds, threads;
    Display display;
};

std::string percents(double share) {
    return digits(100 * share) + " %";
}

std::string wallAndProcessor(const Seconds& seconds) {
    return digits(1000 * seconds.wall) + " / " + digits(1000 * seconds.processor);
}

/// Tables with a row for each number of samples.
class Table {
  public:
    void add(const Film& film, const Film& reference, const Plan& plan) {
        const Display raw = plan.display.withDenoised(false), smooth = plan.display.withDenoised(true);
        const FilmStatus status = film.status(plan.display);
        const TrueError rawError = trueError(film, raw, reference), error = trueError(film, smooth, reference);
        const auto judgement = SmoothingJudgement::of(film);
        const auto stated = judgement ? judgement->overAll(plan.display) : std::nullopt;
        const Costs costs = costsOf(film, raw, plan.rounds);
        const std::string samples = std::to_string(film.samplesPerPixel());
        relative_.add({samples, percents(rawError.relative), percents(status.relativeError), percents(error.relative),
                       stated ? percents(stated->relative) : "-", stated ? percents(stated->relativeAtMost) : "-"});
        levels_.add({samples, digits(rawError.levels), digits(status.displayError), digits(error.levels),
                     stated ? digits(stated->levels) : "-", stated ? digits(stated->levelsAtMost) : "-"});
        costs_.add({samples, wallAndProcessor(costs.raw), wallAndProcessor(costs.denoised),
                    wallAndProcessor(costs.judgement)});
    }

    void print() const {
        std::printf("root mean square error over the tissue's mean\n%s\n", relative_.text().c_str());
        std::printf("display levels of 255 that 95 %% of the tissue are off, at most\n%s\n", levels_.text().c_str());
        std::printf("milliseconds of an image: wall / processor\n%s", costs_.text().c_str());
    }

  private:
    paper::TextTable relative_{{"samples", "raw", "stated", "denoised", "stated", "at most"}};
    paper::TextTable levels_{{"samples", "raw", "stated", "denoised", "stated", "at most"}};
    paper::TextTable costs_{{"samples", "raw", "denoised", "its judgement"}};
};

/// Takes `samples` more samples on `film` and returns all that are taken.
Result<std::shared_ptr<const Film>> grown(LiveImage& film, std::uint32_t samples) {
    if (const Result<void> done = film.live->accumulate(samples, {}); !done)
        return done.error();
    return film.live->film();
}

Result<void> compare(const Scene& scene, const Plan& plan) {
    // Render the reference with other random numbers
    Scene other = scene;
    other.seed += 1;
    Result<LiveImage> truth = startFilm(other, "cpu", plan.threads);
    if (!truth)
        return truth.error();
    const auto reference = grown(*truth, std::uint32_t(plan.reference));
    if (!reference)
        return reference.error();
    // Compare with it after 1, 4, 16, ... samples
    Result<LiveImage> film = startFilm(scene, "cpu", plan.threads);
    if (!film)
        return film.error();
    Table table;
    int taken = 0;
    for (int samples = 1; samples <= plan.samples; samples *= 4) {
        const auto known = grown(*film, std::uint32_t(samples - taken));
        if (!known)
            return known.error();
        taken = samples;
        table.add(**known, **reference, plan);
    }
    table.print();
    return {};
}

}  // namespace

int smoothing(const Arguments& arguments) {
    const auto options = Options::read(
        arguments, {"--samples", "--reference", "--rounds", "--threads", "--width", "--height", "--exposure"});
    const auto number = [&](const char* name, int otherwise, int least) {
        return options ? options->number(name, otherwise, least) : std::nullopt;
    };
    const auto samples = number("--samples", 64, 1), reference = number("--reference", 1024, 2);
    const auto rounds = number("--rounds", 5, 1), threads = number("--threads", 0, 0);
    const auto width = number("--width", 960, 1), height = number("--height", 640, 1);
    const auto exposure = options ? options->positive("--exposure", 1) : std::nullopt;
    if (!samples || !reference || !rounds || !threads || !width || !height || !exposure || options->files.size() != 1)
        return 2;
    Result<Scene> scene = loadScene(options->files[0]);
    if (!scene)
        return fail(scene.error());
    scene->film = {*width, *height};
    const Result<void> done =
        compare(*scene, {*samples, *reference, *rounds, *threads, Display{float(*exposure), false}});
    return done ? 0 : fail(done.error());
}

}  // namespace pdr::bench
