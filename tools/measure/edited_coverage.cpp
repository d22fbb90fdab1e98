/// Measures whether what is stated of an image after an edit of its look covers what it claims, over random edits.
///   edited_coverage FOLDER... [--edits N] [--size N] [--reference N] [--threads N]
/// FOLDER holds a CT; N edits (default 400) are spread over the folders, kLooks and five kinds of edits. An edit is of
/// a random amount, small ones as likely as large ones; before it the film has 16, 64 or 256 samples. Prints, for the
/// image after 4, 16, 64 and 256 samples and each kind of edit: the share of the tissue within the margin stated for 95
/// % of it and within the upper end of that [%], and that upper end over the error that 95 % of the tissue does not
/// exceed, the median of all images. The truth of an image is the denoised image of --reference samples (default 2048)
/// of a distant seed; eight edits in a row are of one kind and amount and share it.

#include <QCoreApplication>
#include <array>
#include <cstdio>
#include <map>
#include <random>

#include "app/bench/options.h"
#include "app/cli/scene/scene_input.h"
#include "app/looks/looks.h"
#include "render/edit/light_change.h"
#include "tools/measure/edit_trial.h"
#include "tools/measure/stated_figures.h"

namespace pdr::test {
namespace {

constexpr std::array<const char*, 4> kLooks{"Bone", "Vessels and bone", "Muscles", "Skin"};
constexpr std::array<std::uint64_t, 4> kSamples{4, 16, 64, 256};
constexpr int kEditsOfOneTruth = 8;

struct Plan {
    int edits, size, reference, threads;
};

/// An edit as editedLook() reads it.
struct RandomEdit {
    std::string kind;
    QString text;
};

/// Returns a number between `least` and `most`, its logarithm evenly distributed.
double between(std::mt19937_64& numbers, double least, double most) {
    return least * std::pow(most / least, std::uniform_real_distribution<>()(numbers));
}

/// Returns an edit of the kind of that turn.
RandomEdit randomEdit(std::mt19937_64& numbers, int turn) {
    const double sign = numbers() % 2 == 0 ? 1 : -1;
    std::pair<const char*, double> edit;
    switch (turn % 5) {
        case 0:
            edit = {"node", sign * between(numbers, 5, 200)};
            break;
        case 1:
            edit = {"curve", sign * between(numbers, 5, 100)};
            break;
        case 2:
            edit = {"opacity", std::exp(sign * between(numbers, 0.02, 0.7))};
            break;
        case 3:
            edit = {"albedo", std::exp(-between(numbers, 0.02, 0.7))};
            break;
        default:
            edit = {"lights", sign * between(numbers, 1, 40)};
    }
    return {edit.first, QString("%1:%2").arg(edit.first).arg(edit.second)};
}

/// What is stated of images, and what is so.
struct Row {
    Share within, withinAtMost, judged;
    Slack slack;

    void add(const Film& film, const denoise::Colours& radiance, const denoise::Colours& truth,
             const std::optional<DenoisedError>& said, const Tone& tone) {
        judged.add(said.has_value());
        if (!said)
            return;
        std::vector<double> levels;
        for (int y = 0; y < film.size().y; ++y)
            for (int x = 0; x < film.size().x; ++x)
                if (film.pixel(x, y).tissue) {
                    const dvec3 right = at(truth, x, y);
                    const double off = double(levelsOff(displayTransform(tone), right, at(radiance, x, y) - right));
                    levels.push_back(off);
                    within.add(off <= said->levels);
                    withinAtMost.add(off <= said->levelsAtMost);
                }
        slack.add(said->levelsAtMost, levels, 0);
    }
    void print(const char* kind, std::uint64_t samples) const {
        std::printf("%-8s %4llu samples  stated of %s %% of %.0f images  within %s %%  at most %s %%  slack %.2f\n",
                    kind, (unsigned long long)samples, judged.text().c_str(), judged.all, within.text().c_str(),
                    withinAtMost.text().c_str(), slack.median().value_or(0));
    }
};

using Rows = std::map<std::pair<std::string, std::uint64_t>, Row>;

denoise::Colours denoisedImage(const Film& film) {
    const NoisyFilm noisy = noisyFilm(film);
    return scaled(smoothRadiance(noisy), float(noisy.unit));
}

/// The images of `after` that the film of `before`, of `old` samples, helps to make.
void tryEdit(Device& device, const Scene& before, const Scene& after, std::uint64_t old, const denoise::Colours& truth,
             const Tone& tone, const std::string& kind, Rows& rows) {
    SampledScene then = sampledScene(device, before);
    EditedImage edited(keptImageOf(then, old));
    SampledScene now = sampledScene(device, after);
    for (const std::uint64_t samples : kSamples) {
        const std::shared_ptr<const Film> film = now.at(samples);
        const auto judged = SmoothingJudgement::of(*film, [&](const NoisyFilm& halves, const std::stop_token& stop) {
            return edited.halves(halves, denoisedHalves(halves, stop), samples, now.first);
        });
        const std::optional<DenoisedError> said = judged ? judged->overAll(tone) : std::nullopt;
        const denoise::Colours radiance = edited.radiance(*film, now.first, {});
        for (const std::string& name : {kind, std::string("all")})
            rows[{name, samples}].add(*film, radiance, truth, said, tone);
    }
}

/// All edits of a turn, which have one truth; `number` of the first one, which chooses their seeds.
bool tryEdits(const std::string& folder, const NamedLook& look, int turn, int number, const Plan& plan, Rows& rows) {
    const int count = std::min(kEditsOfOneTruth, plan.edits - number);
    const app::SceneInput input{.path = folder, .look = look, .size = ivec2(plan.size), .autoExposure = true};
    const auto loaded = app::loadScene(input, noProgress);
    if (!loaded) {
        std::fprintf(stderr, "%s: %s\n", folder.c_str(), loaded.error().what.c_str());
        return false;
    }
    std::mt19937_64 numbers(std::uint64_t(number) + 1);
    const RandomEdit edit = randomEdit(numbers, turn);
    const std::unique_ptr<Device> device = makeCpuDevice(plan.threads);
    Scene before = loaded->scene, after = withLook(before, *editedLook(look.look, edit.text));
    ++after.revision;
    after.seed = 500'000'000 + std::uint64_t(number);
    SampledScene best{*startFilm(*device, after), {}};
    const denoise::Colours truth = denoisedImage(*best.at(std::uint64_t(plan.reference)));
    for (int i = 0; i < count; ++i) {
        before.seed = after.seed = 1000 * std::uint64_t(number + i);
        const std::uint64_t old = std::array{16, 64, 256}[std::size_t(number / kEditsOfOneTruth + i) % 3];
        tryEdit(*device, before, after, old, truth, loaded->display, edit.kind, rows);
    }
    return true;
}

}  // namespace
}  // namespace pdr::test

int main(int count, char** words) {
    using namespace pdr;
    QCoreApplication application(count, words);
    const auto options =
        bench::Options::read({words + 1, words + count}, {"--edits", "--size", "--reference", "--threads"});
    const auto edits = options ? options->number("--edits", 400, 1) : std::nullopt;
    const auto size = options ? options->number("--size", 96, 64) : std::nullopt;
    const auto reference = options ? options->number("--reference", 2048, 16) : std::nullopt;
    const auto threads = options ? options->number("--threads", 0, 0) : std::nullopt;
    const auto looks = app::bundledLooks();
    if (!edits || !size || !reference || !threads || options->files.empty() || !looks) {
        std::fprintf(stderr, "usage: edited_coverage FOLDER... [--edits N] [--size N] [--reference N] [--threads N]\n");
        return 2;
    }
    const test::Plan plan{*edits, *size, *reference, *threads};
    test::Rows rows;
    const int step = test::kEditsOfOneTruth;
    for (int number = 0, turn = 0; number < plan.edits; number += step, ++turn) {
        const std::string& folder = options->files[std::size_t(turn) % options->files.size()];
        const int ofFolder = turn / int(options->files.size());
        const char* name = test::kLooks[std::size_t(ofFolder) % test::kLooks.size()];
        const auto look = std::ranges::find(*looks, name, &NamedLook::name);
        if (look == looks->end() || !test::tryEdits(folder, *look, ofFolder, number, plan, rows))
            return 1;
        std::fprintf(stderr, "%d of %d edits\n", std::min(number + step, plan.edits), plan.edits);
    }
    for (const auto& [key, row] : rows)
        row.print(key.first.c_str(), key.second);
    return 0;
}
