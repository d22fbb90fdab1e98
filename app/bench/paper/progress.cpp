#include "app/bench/paper/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace pdr::bench::paper {

namespace {

constexpr std::chrono::seconds kPlainEvery{10};

}  // namespace

Progress::Progress() : terminal_(::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (open_)
        std::fputs("\r\033[K", stderr);
}

void Progress::show(const std::string& what, double secondsLeft) {
    const long left = std::lround(secondsLeft);
    const auto now = std::chrono::steady_clock::now();
    if (!terminal_ && now - last_ < kPlainEvery)
        return;
    last_ = now;
    std::fprintf(stderr, terminal_ ? "\r\033[K%s, about %ld:%02ld left" : "%s, about %ld:%02ld left\n", what.c_str(),
                 left / 60, left % 60);
    std::fflush(stderr);
    open_ = terminal_;
}

}  // namespace pdr::bench::paper
