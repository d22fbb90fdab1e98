#include "app/cli/progress_line.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "app/cli/error_text.h"

namespace pdr::app {
namespace {

constexpr int kBarWidth = 24;
constexpr std::chrono::seconds kPlainEvery{5};

template <class... Arguments>
std::string formatted(const char* format, Arguments... arguments) {
    char text[160];
    std::snprintf(text, sizeof text, format, arguments...);
    return text;
}

}  // namespace

ProgressLine::ProgressLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    finish();
}

void ProgressLine::show(double fraction, std::string_view step) {
    draw(fraction, std::string(step));
}

void ProgressLine::show(const BatchState& state) {
    std::string text = "rendering: " + samplesText(std::uint64_t(std::llround(state.film.meanSamplesPerPixel))) + ", " +
                       errorText(state.film);
    if (state.secondsLeft)
        text += ", " + clockText(*state.secondsLeft) + " left";
    draw(state.fraction, text);
}

void ProgressLine::draw(double fraction, const std::string& text) {
    const int percent = int(100 * std::clamp(fraction, 0.0, 1.0));
    if (terminal_) {
        const int filled = percent * kBarWidth / 100;
        const std::string bar =
            std::string(std::size_t(filled), '#') + std::string(std::size_t(kBarWidth - filled), '.');
        std::fprintf(stderr, "\r\033[K[%s] %3d %%  %s", bar.c_str(), percent, text.c_str());
        std::fflush(stderr);
        open_ = true;
        return;
    }
    const auto now = std::chrono::steady_clock::now();
    const std::string step = text.substr(0, text.find(':'));
    if (step == lastStep_ && now - lastPlain_ < kPlainEvery)
        return;
    lastStep_ = step;
    lastPlain_ = now;
    std::fprintf(stderr, "%3d %%  %s\n", percent, text.c_str());
}

Progress ProgressLine::until(std::stop_token stop) {
    return [this, stop = std::move(stop)](double fraction, std::string_view step) {
        show(fraction, step);
        return !stop.stop_requested();
    };
}

void ProgressLine::finish() {
    if (open_)
        std::fprintf(stderr, "\n");
    open_ = false;
}

std::string clockText(double seconds) {
    const long whole = std::lround(std::min(seconds, 1e9));
    if (whole >= 3600)
        return formatted("%ld:%02ld:%02ld", whole / 3600, whole / 60 % 60, whole % 60);
    return formatted("%ld:%02ld", whole / 60, whole % 60);
}

std::string samplesText(std::uint64_t samplesPerPixel) {
    return std::to_string(samplesPerPixel) + (samplesPerPixel == 1 ? " sample per pixel" : " samples per pixel");
}

}  // namespace pdr::app
