/// Measures whether every figure that is stated about an image's error covers what it claims, over seeds, looks,
/// volumes and samples. The truth of an image is the mean of the images of all other seeds at the most samples, with
/// which it shares no number.
///   stated_coverage RESULTS.csv NAME=FOLDER... [--looks A,B,...] [--seeds N] [--size N] [--threads N]
/// FOLDER holds a CT, or is a scene file; looks are those that are shipped, by name. RESULTS.csv gets a line for each
/// volume, look and number of samples as soon as it is known; what it holds already is not computed again. Columns in
/// per cent, empty where nothing is stated; 95 is the target of each of them, except for `bound`:
///   sentence            share of the tissue within the margin stated for 95 % of it
///   denoised, at_most   share of the tissue in the denoised image within its stated margin, and within the upper
///                       end of that
///   strip               share of the images that reach 0.6 of the error within the predicted range of samples
///   map, denoised_map   share of the tissue's pixels within the margins of the error map, of either image
///   error, bound        share of the tissue's channels within 1.96 times error.* and bound.* of an OpenEXR file
/// and beside them: unknown, the tissue for which map and file state nothing; unmet, the tissue that no sample has met,
/// and unmet_stated, the mean of what is stated for that; ratio, the root mean square error over the stated
/// relativeError; slack, the upper end of what is stated of the denoised image over the error that 95 % of its tissue
/// does not exceed, the median of all images; seconds, of all seeds. At the end a table of all lines in RESULTS.csv is
/// printed.

#include <QCoreApplication>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/bench/options.h"
#include "app/cli/scene/scene_input.h"
#include "app/looks/looks.h"
#include "tools/measure/coverage_table.h"
#include "tools/measure/stated_figures.h"

namespace pdr::test {
namespace {

constexpr std::array<std::uint64_t, 3> kSamples{16, 64, 256};

struct Plan {
    std::string results;
    int seeds, size, threads;
};

/// Returns the looks named in a list, all for an empty list.
std::vector<NamedLook> chosen(const std::vector<NamedLook>& looks, const std::string& names) {
    std::vector<NamedLook> found;
    std::istringstream list(names);
    for (std::string name; std::getline(list, name, ',');)
        std::ranges::copy_if(looks, std::back_inserter(found),
                             [&](const NamedLook& look) { return look.name == name; });
    return names.empty() ? looks : found;
}

/// One seed's images, and whether its forecast came true.
struct Series {
    std::vector<StatedImage> images;
    std::optional<bool> foretold;
};

/// Renders until 0.6 of the error at 64 samples is reached, and all images are there.
Series grown(Device& device, const Scene& scene, const Tone& tone) {
    const auto film = startFilm(device, scene);
    Series series;
    Forecast forecast;
    for (std::uint64_t done = 0; done < kSamples.back();) {
        std::uint64_t next = done + std::max<std::uint64_t>(done / 12, 8);
        for (const std::uint64_t stop : kSamples)
            next = done < stop ? std::min(next, stop) : next;
        if (!film || !(*film)->accumulate(std::uint32_t(next - done), {}))
            qFatal("cannot be rendered");
        done = next;
        const std::shared_ptr<const Film> known = *(*film)->film();
        forecast.look(known->status(tone), kSamples[1]);
        if (std::ranges::find(kSamples, done) != kSamples.end())
            series.images.push_back(statedImage(*known, tone));
    }
    series.foretold = forecast.cameTrue();
    return series;
}

std::vector<Series> allSeries(Scene scene, const Tone& tone, const Plan& plan) {
    const std::unique_ptr<Device> device = makeCpuDevice(plan.threads);
    std::vector<Series> all;
    for (int seed = 1; seed <= plan.seeds; ++seed) {
        scene.seed = std::uint64_t(seed);
        ++scene.revision;
        all.push_back(grown(*device, scene, tone));
    }
    return all;
}

Figures figuresOf(const std::vector<Series>& all, std::size_t step, const Tone& tone) {
    Truth truth(all.front().images.back().light.size());
    for (const Series& one : all)
        truth.add(one.images.back());
    Figures figures;
    std::vector<const StatedImage*> best;
    for (const Series& one : all)
        best.push_back(&one.images.back());
    figures.setTruthNoise(best, truth, tone);
    for (const Series& one : all) {
        figures.add(one.images[step], truth.without(one.images.back()), tone);
        if (kSamples[step] == kSamples[1] && one.foretold)
            figures.strip.add(*one.foretold);
    }
    return figures;
}

bool isThere(const std::string& file, const std::string& key) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(key))
            return true;
    return false;
}

void measure(const Plan& plan, const std::string& volume, const std::string& folder, const NamedLook& look) {
    const std::string key = volume + "," + look.name + ",";
    if (isThere(plan.results, key))
        return;
    const app::SceneInput input{.path = folder, .look = look, .size = ivec2(plan.size), .autoExposure = true};
    const auto loaded = app::loadScene(input, noProgress);
    if (!loaded) {
        std::fprintf(stderr, "%s %s: %s\n", volume.c_str(), look.name.c_str(), loaded.error().what.c_str());
        return;
    }
    const auto start = std::chrono::steady_clock::now();
    const Tone tone = loaded->display;
    const std::vector<Series> all = allSeries(loaded->scene, tone, plan);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    std::ofstream out(plan.results, std::ios::app);
    for (std::size_t step = 0; step < kSamples.size(); ++step)
        out << key << kSamples[step] << "," << plan.seeds << "," << figuresOf(all, step, tone).text() << ","
            << std::int64_t(seconds) << std::endl;
}

}  // namespace
}  // namespace pdr::test

int main(int count, char** words) {
    using namespace pdr;
    QCoreApplication application(count, words);
    const auto options =
        bench::Options::read({words + 1, words + count}, {"--looks", "--seeds", "--size", "--threads"});
    const auto seeds = options ? options->number("--seeds", 30, 3) : std::nullopt;
    const auto size = options ? options->number("--size", 96, 64) : std::nullopt;
    const auto threads = options ? options->number("--threads", 1, 0) : std::nullopt;
    const auto looks = app::bundledLooks();
    if (!seeds || !size || !threads || options->files.size() < 2 || !looks) {
        std::fprintf(stderr,
                     "usage: stated_coverage RESULTS.csv NAME=FOLDER... [--looks A,B,...] [--seeds N] [--size N] "
                     "[--threads N]\n");
        return 2;
    }
    const test::Plan plan{options->files[0], *seeds, *size, *threads};
    if (!test::isThere(plan.results, "volume,"))
        std::ofstream(plan.results, std::ios::app)
            << "volume,look,samples,seeds," << test::kFigureNames << ",seconds\n";
    for (const NamedLook& look : test::chosen(*looks, options->word("--looks", "")))
        for (std::size_t i = 1; i < options->files.size(); ++i) {
            const std::string& word = options->files[i];
            const std::size_t equal = word.find('=');
            test::measure(plan, word.substr(0, equal), word.substr(equal + 1), look);
        }
    test::printCoverage(plan.results, test::kSamples);
    return 0;
}
