#include "app/bench/paper/frame_clock.h"

#include <chrono>
#include <cmath>

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

double sampleNoise(const FilmStatus& status) {
    return status.relativeError * std::sqrt(double(status.samplesPerPixel));
}

}  // namespace

Result<Lap> timeFrames(LiveFilm& film, std::uint32_t n, const Display& display, double seconds, std::stop_token stop) {
    const Clock::time_point began = Clock::now();
    Clock::time_point first = began, last = began;
    std::uint64_t taken = 0;
    Lap lap;
    for (int waiting = 0; true; --waiting) {
        for (; waiting < film.ahead(); ++waiting)
            if (Result<void> ordered = order(film, n, display, stop); !ordered)
                return ordered.error();
        const Result<Picture> picture = film.take();
        if (!picture)
            return picture.error();
        if (stop.stop_requested())
            return lap;
        ++taken;
        last = Clock::now();
        if (taken > 1)
            lap = {between(first, last), taken - 1, sampleNoise(picture->status)};
        else if (between(began, last) >= seconds)
            return Lap{between(began, last), 1, sampleNoise(picture->status)};
        else
            first = last;
        if (taken > 1 && lap.seconds >= seconds)
            return lap;
    }
}

}  // namespace pdr::bench::paper
