#include "app/bench/scale/settings.h"

#include <algorithm>
#include <iterator>
#include <system_error>

#include "app/bench/options.h"
#include "render/base/tile.h"

namespace pdr::bench::scale {

namespace {

constexpr const char* kNames[] = {"--device",      "--threads",     "--seconds",   "--width",     "--height",
                                  "--samples",     "--per-launch",  "--launch",    "--sample",    "--pixel",
                                  "--serial",      "--latency",     "--bandwidth", "--message",   "--tiles",
                                  "--nodes",       "--pixel-bytes", "--sum-bytes", "--plots",     "--measured",
                                  "--order-bytes", "--checked",     "--relays",    "--scan-bytes"};

/// Reads values by their names, and keeps the first error.
class Reader {
  public:
    explicit Reader(const Options& options) : options_(options) {}

    template <class Number>
    void whole(const char* name, int least, Number& value) {
        if (const auto read = options_.number(name, int(value), least))
            value = Number(*read);
        else
            wrong(name, "Give a whole number from " + std::to_string(least) + ".");
    }
    void positive(const char* name, double& value) {
        if (const auto read = options_.positive(name, value))
            value = *read;
        else
            wrong(name, "Give a number above 0.");
    }
    void positive(const char* name, std::optional<double>& value) {
        if (options_.named.contains(name))
            positive(name, value.emplace(0));
    }
    const Result<void>& result() const { return result_; }

  private:
    void wrong(const char* name, const std::string& hint) {
        if (result_)
            result_ = Error{"this value cannot be", std::string(name) + " " + options_.word(name, ""), hint};
    }

    const Options& options_;
    Result<void> result_;
};

/// Returns an error for the word that makes `arguments` unreadable.
Error wrongWord(const Arguments& arguments) {
    for (const std::string& word : arguments)
        if (word.starts_with("--") && word != "--json" && std::ranges::find(kNames, word) == std::end(kNames))
            return {"there is no such option", word, "pdrender-bench help scale lists them."};
    return {"the value is missing", arguments.back(), ""};
}

Result<void> readNumbers(const Options& options, Settings& settings) {
    ScalingFacts& facts = settings.facts;
    int width = 1920, height = 1080;
    Reader reader(options);
    reader.whole("--threads", 0, settings.threads);
    reader.positive("--seconds", settings.seconds);
    reader.whole("--width", 16, width);
    reader.whole("--height", 16, height);
    reader.whole("--samples", 1, facts.work.iterations);
    reader.whole("--per-launch", 1, facts.work.perLaunch);
    reader.positive("--launch", settings.launch);
    reader.positive("--sample", settings.sample);
    reader.positive("--pixel", settings.pixel);
    reader.positive("--serial", settings.serial);
    reader.positive("--latency", facts.link.latency);
    reader.positive("--bandwidth", facts.link.bytesPerSecond);
    reader.positive("--message", facts.link.messageSeconds);
    reader.whole("--tiles", 1, facts.tilesPerNode);
    reader.whole("--nodes", 1, settings.mostNodes);
    reader.positive("--pixel-bytes", facts.pixelBytes);
    reader.positive("--order-bytes", facts.orderBytes);
    reader.positive("--sum-bytes", facts.sumBytes);
    reader.positive("--checked", facts.checkedPart);
    reader.whole("--relays", 0, facts.relays);
    reader.positive("--scan-bytes", facts.scanBytes);
    facts.work.pixels = double(width) * height;
    settings.measuresNode = !(settings.launch && settings.sample && settings.pixel && settings.serial);
    return reader.result();
}

/// Returns the folder, which is made if necessary. It is checked before the measurement, so that a missing folder is
/// reported at once.
Result<std::filesystem::path> folderFor(const std::string& word) {
    std::error_code failed;
    std::filesystem::create_directory(word, failed);
    if (!std::filesystem::is_directory(word))
        return Error{"there is no such folder, and none can be made", word, "Create it, or choose another place."};
    return std::filesystem::path(word);
}

}  // namespace

FrameTimeModel Settings::nodeOf(FrameTimeModel fitted) const {
    return {launch.value_or(fitted.launch), sample.value_or(fitted.sample), pixel.value_or(fitted.pixel),
            serial.value_or(fitted.communication)};
}

Result<Settings> settingsFrom(const Arguments& arguments) {
    const auto options = Options::read(arguments, {std::begin(kNames), std::end(kNames)}, {"--json"});
    if (!options)
        return wrongWord(arguments);
    Settings settings;
    settings.facts.work = {0, 256, kSamplesPerBlock};
    if (options->files.size() > 1)
        return Error{"only one scene can be measured", options->files[1], ""};
    if (!options->files.empty())
        settings.sceneFile = options->files[0];
    settings.device = options->word("--device", settings.device);
    settings.json = options->named.contains("--json");
    if (const auto read = readNumbers(*options, settings); !read)
        return read.error();
    if (options->named.contains("--measured"))
        settings.measured = options->word("--measured", "");
    if (options->named.contains("--plots")) {
        auto folder = folderFor(options->word("--plots", ""));
        if (!folder)
            return folder.error();
        settings.plots = *std::move(folder);
    }
    return settings;
}

}  // namespace pdr::bench::scale
