#include "app/bench/paper/settings.h"

#include <unistd.h>

#include <algorithm>

#include "app/bench/options.h"

namespace pdr::bench::paper {

namespace {

constexpr const char* kNames[] = {"--device", "--threads", "--out",       "--seconds",
                                  "--rounds", "--largest", "--estimator", "--clock"};

std::optional<std::string> named(const Options& options, const char* name) {
    const auto found = options.named.find(name);
    return found == options.named.end() ? std::nullopt : std::optional(found->second);
}

Result<void> readNumbers(const Options& options, Settings& settings) {
    const auto threads = options.number("--threads", 0, 0),
               rounds = options.number("--rounds", settings.plan.rounds, 1);
    const auto seconds = options.positive("--seconds", settings.plan.seconds);
    if (!threads)
        return Error{"this is no number of threads", "--threads " + *named(options, "--threads"),
                     "Give a whole number; 0 takes one per core."};
    if (!rounds)
        return Error{"this is no number of rounds", "--rounds " + *named(options, "--rounds"),
                     "Give a whole number from 1."};
    if (!seconds)
        return Error{"this is no time", "--seconds " + *named(options, "--seconds"), "Give seconds, above 0."};
    settings.threads = *threads;
    settings.plan.rounds = *rounds;
    settings.plan.seconds = *seconds;
    return {};
}

Result<void> readLargest(const std::string& word, Plan& plan) {
    const std::optional<ivec2> largest = sizeOf(word);
    if (largest)
        std::erase_if(plan.sizes, [&](ivec2 size) { return size.x > largest->x || size.y > largest->y; });
    if (!largest || plan.sizes.empty())
        return Error{"this leaves no resolution", "--largest " + word, "Give one such as 480x270, at least 60x34."};
    return {};
}

Result<Estimator> estimatorNamed(const std::string& word) {
    if (word == "unbiased")
        return Estimator::unbiased;
    if (word == "kroesMarch")
        return Estimator::kroesMarch;
    return Error{"there is no such estimator", "--estimator " + word, "Choose unbiased or kroesMarch."};
}

Result<TimeOf> timeNamed(const std::string& word, const std::string& device) {
    if (word == "wall")
        return TimeOf::wall;
    if (word != "processor")
        return Error{"there is no such clock", "--clock " + word, "Choose wall or processor."};
    if (device != "cpu")
        return Error{"the processor's time says nothing about another device", "--clock processor --device " + device,
                     "Leave one of them out."};
    return TimeOf::processor;
}

/// Returns the folder, which is made if necessary. It is checked before the measurement, so that a missing folder is
/// reported at once and not after minutes.
Result<std::filesystem::path> folderFor(const std::string& word) {
    std::error_code failed;
    std::filesystem::create_directory(word, failed);
    if (!std::filesystem::is_directory(word))
        return Error{"there is no such folder, and none can be made", word, "Create it, or choose another place."};
    if (::access(word.c_str(), W_OK | X_OK) != 0)
        return Error{"the folder cannot be written to", word, "Choose a folder that you may write to."};
    return std::filesystem::path(word);
}

/// Returns an error for the word that makes `arguments` unreadable.
Error wrongWord(const Arguments& arguments) {
    for (const std::string& word : arguments)
        if (word.starts_with("--") && std::ranges::find(kNames, word) == std::end(kNames))
            return {"there is no such option", word, "Run pdrender-bench without words to see them."};
    return {"the value is missing", arguments.back(), ""};
}

}  // namespace

Result<Settings> settingsFrom(const Arguments& arguments) {
    const auto options = Options::read(arguments, {std::begin(kNames), std::end(kNames)});
    if (!options)
        return wrongWord(arguments);
    Settings settings;
    // Read the scene and the device
    if (options->files.size() > 1)
        return Error{"only one scene can be measured", options->files[1], ""};
    if (!options->files.empty())
        settings.sceneFile = options->files[0];
    settings.device = named(*options, "--device").value_or(settings.device);
    // Read numbers, then words with a closed set of values
    if (const Result<void> read = readNumbers(*options, settings); !read)
        return read.error();
    if (const auto word = named(*options, "--largest"))
        if (const Result<void> read = readLargest(*word, settings.plan); !read)
            return read.error();
    if (const auto word = named(*options, "--estimator")) {
        const Result<Estimator> estimator = estimatorNamed(*word);
        if (!estimator)
            return estimator.error();
        settings.estimator = *estimator;
    }
    if (const auto word = named(*options, "--clock")) {
        const Result<TimeOf> time = timeNamed(*word, settings.device);
        if (!time)
            return time.error();
        settings.plan.time = *time;
    }
    // Make the folder for results
    if (const auto word = named(*options, "--out")) {
        const Result<std::filesystem::path> folder = folderFor(*word);
        if (!folder)
            return folder.error();
        settings.out = *folder;
    }
    return settings;
}

}  // namespace pdr::bench::paper
