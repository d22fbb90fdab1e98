#include "app/bench/paper/frame_clock.h"

#include <cmath>

namespace pdr::bench::paper {

namespace {

Result<void> order(Accumulator& film, std::uint32_t n, const Display& display, std::stop_token stop) {
    if (Result<void> taken = film.accumulate(n, stop); !taken)
        return taken;
    return film.resolve(display);
}

double sampleNoise(const FilmStatus& status) {
    return status.relativeError * std::sqrt(double(status.samplesPerPixel));
}

}  // namespace

Result<Lap> timeFrames(Accumulator& film, std::uint32_t n, const Display& display, double seconds, const WorkClock& now,
                       std::stop_token stop) {
    const double began = now();
    double first = began;
    std::uint64_t taken = 0;
    Lap lap;
    for (int waiting = 0; true; --waiting) {
        for (; waiting < film.maxInFlight(); ++waiting)
            if (Result<void> ordered = order(film, n, display, stop); !ordered)
                return ordered.error();
        const Result<Image> image = film.readback();
        if (!image)
            return image.error();
        if (stop.stop_requested())
            return lap;
        ++taken;
        const double last = now();
        if (taken > 1)
            lap = {last - first, taken - 1, sampleNoise(image->status)};
        else if (last - began >= seconds)
            return Lap{last - began, 1, sampleNoise(image->status)};
        else
            first = last;
        if (taken > 1 && lap.seconds >= seconds)
            return lap;
    }
}

}  // namespace pdr::bench::paper
