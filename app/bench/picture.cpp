#include <chrono>
#include <cmath>
#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/options.h"
#include "app/bench/pfm.h"
#include "render/film/film.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace {

GreyImage greyImage(const Film& film) {
    GreyImage image{film.size(), {}};
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x)
            image.pixels.push_back(float(luminance(film.pixel(x, y).mean)));
    return image;
}

/// Returns the error as JSON: null if it is not finite, because JSON has no infinity.
std::string errorInJson(double relativeError) {
    char text[32];
    std::snprintf(text, sizeof text, "%.5g", relativeError);
    return std::isfinite(relativeError) ? text : "null";
}

}  // namespace

int image(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--samples", "--threads", "--pfm", "--device"});
    const auto samples = options ? options->number("--samples", 64, 1) : std::nullopt;
    const auto threads = options ? options->number("--threads", 0, 0) : std::nullopt;
    if (!samples || !threads || options->files.size() != 1)
        return 2;
    const Result<Scene> scene = loadScene(options->files[0]);
    if (!scene)
        return fail(scene.error());
    const auto film = startFilm(*scene, options->word("--device", "cpu"), *threads);
    if (!film)
        return fail(film.error());

    // Time the rendering up to the image that is shown
    const auto start = std::chrono::steady_clock::now();
    const auto accumulated = film->live->accumulate(std::uint32_t(*samples), {});
    const auto ordered = accumulated ? film->live->resolve({}) : accumulated;
    const auto shown = ordered ? film->live->readback() : Result<Image>(ordered.error());
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!shown)
        return fail(shown.error());
    const FilmStatus& status = shown->status;
    std::printf(
        "{\"samples\": %d, \"seconds\": %.4f, \"samplesPerSecond\": %.4g, \"mean\": %.7g, \"relativeError\": %s, "
        "\"rejected\": %llu}\n",
        *samples, seconds, double(*samples) * scene->film.x * scene->film.y / seconds, status.meanLuminance,
        errorInJson(status.relativeError).c_str(), static_cast<unsigned long long>(status.health.rejected()));
    if (const auto pfm = options->named.find("--pfm"); pfm != options->named.end()) {
        const auto all = film->live->film();
        if (!all)
            return fail(all.error());
        if (const auto written = writePfm(greyImage(**all), pfm->second); !written)
            return fail(written.error());
    }
    return 0;
}

int compare(const Arguments& arguments) {
    if (arguments.size() != 2)
        return 2;
    const Result<GreyImage> image = readPfm(arguments[0]), reference = readPfm(arguments[1]);
    if (!image || !reference)
        return fail(image ? reference.error() : image.error());
    if (image->size != reference->size)
        return fail({"the images differ in size", arguments[0], ""});
    double mean = 0, truth = 0, squares = 0;
    for (std::size_t i = 0; i < image->pixels.size(); ++i) {
        const double difference = double(image->pixels[i]) - reference->pixels[i];
        mean += image->pixels[i];
        truth += reference->pixels[i];
        squares += difference * difference;
    }
    const double pixels = double(image->pixels.size());
    std::printf("{\"meanRatio\": %.6f, \"relativeRmse\": %.5f}\n", mean / truth,
                std::sqrt(squares / pixels) / (truth / pixels));
    return 0;
}

}  // namespace pdr::bench
