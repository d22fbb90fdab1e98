#include "app/bench/paper/frame_clock.h"

#include <chrono>

namespace pdr::bench::paper {

namespace {

using Clock = std::chrono::steady_clock;

double between(Clock::time_point from, Clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

Result<void> order(LiveFilm& film, std::uint32_t n, const Display& display, std::stop_token stop) {
    if (Result<void> taken = film.iterate(n, stop); !taken)
        return taken;
    return film.show(display);
}

}  // namespace

Result<Lap> timeFrames(LiveFilm& film, std::uint32_t n, const Display& display, double seconds, std::stop_token stop) {
    const Clock::time_point began = Clock::now();
    Clock::time_point first = began, last = began;
    std::uint64_t taken = 0;
    int waiting = 0;
    while (true) {
        for (; waiting < film.ahead(); ++waiting)
            if (Result<void> ordered = order(film, n, display, stop); !ordered)
                return ordered.error();
        if (const Result<Picture> picture = film.take(); !picture)
            return picture.error();
        if (stop.stop_requested())
            return taken > 1 ? Lap{between(first, last), taken - 1} : Lap{};
        --waiting;
        ++taken;
        last = Clock::now();
        if (taken > 1 && between(first, last) >= seconds)
            return Lap{between(first, last), taken - 1};
        if (taken == 1 && between(began, last) >= seconds)
            return Lap{between(began, last), 1};
        if (taken == 1)
            first = last;
    }
}

}  // namespace pdr::bench::paper
