#include "app/bench/paper/measurement.h"

#include <algorithm>
#include <cmath>

#include "render/prepare/flatten.h"

namespace pdr::bench::paper {

namespace {

/// Returns the quantile `fraction` of ordered values, interpolated linearly.
double quantile(const std::vector<double>& ordered, double fraction) {
    const double place = fraction * double(ordered.size() - 1);
    const std::size_t below = std::size_t(place);
    const std::size_t above = std::min(below + 1, ordered.size() - 1);
    return ordered[below] + (place - double(below)) * (ordered[above] - ordered[below]);
}

double samples(const Cell& cell) {
    return double(cell.size.x) * cell.size.y * kWays[cell.way].iterations;
}

class Experiment {
  public:
    Experiment(Device& device, const Display& display, const Plan& plan, const WorkClock& now, DeviceLoad& load,
               const OnMeasurement& onMeasurement, std::stop_token stop, Measured& measured)
        : device_(device),
          display_(display),
          plan_(plan),
          now_(now),
          load_(load),
          onMeasurement_(onMeasurement),
          stop_(std::move(stop)),
          measured_(measured) {}

    Result<void> prepare(Scene scene) {
        for (const ivec2 size : plan_.sizes) {
            scene.film = size;
            ++scene.revision;
            if (Result<void> sound = scene.check(); !sound)
                return sound;
            scenes_.push_back(scene);
            for (int way = 0; way < kWayCount; ++way)
                measured_.cells.push_back({size, WayPlace(way), {}});
        }
        return {};
    }

    /// Measures all cells once, the smallest images first, because they soon show how long the others will take.
    Result<void> round(int number) {
        for (std::size_t size = plan_.sizes.size(); size-- > 0;) {
            bool uploaded = false;
            for (int way = 0; way < kWayCount; ++way) {
                Cell& cell = measured_.cells[size * kWayCount + std::size_t(way)];
                if (stop_.stop_requested())
                    return {};
                if (spent(cell))
                    continue;
                if (!uploaded)
                    if (Result<void> there = device_.upload(scenes_[size]); !there)
                        return there;
                uploaded = true;
                onMeasurement_(cell, number, secondsLeft(number));
                if (Result<void> ran = run(cell, scenes_[size].revision); !ran)
                    return ran.error().in(text(cell.size) + " " + kWays[cell.way].title());
            }
        }
        return {};
    }

  private:
    bool spent(const Cell& cell) const { return cell.measured() && cell.seconds() >= plan_.seconds; }
    double fraction() const { return plan_.seconds / plan_.rounds; }

    Result<void> run(Cell& cell, std::uint64_t revision) {
        const Way& way = kWays[cell.way];
        const auto film = device_.film(cell.size, revision, way.schedule);
        if (!film)
            return film.error();
        load_.start();
        const Result<Lap> lap = timeFrames(**film, way.iterations, display_, fraction(), now_, stop_);
        const std::optional<double> load = load_.stop();
        if (!lap)
            return lap.error();
        if (lap->frames > 0)
            cell.runs.push_back({*lap, load});
        return {};
    }

    /// Returns the expected seconds per frame of a cell. One that was not measured yet is expected to take as long per
    /// sample as the last one that was.
    double frameSeconds(const Cell& cell, double secondsPerSample) const {
        return cell.measured() ? cell.spread().median : secondsPerSample * samples(cell);
    }

    double secondsLeft(int round) const {
        double left = 0, secondsPerSample = 0;
        for (std::size_t size = plan_.sizes.size(); size-- > 0;)
            for (int way = 0; way < kWayCount; ++way) {
                const Cell& cell = measured_.at(size, WayPlace(way));
                if (cell.measured())
                    secondsPerSample = cell.spread().median / samples(cell);
                const double frame = frameSeconds(cell, secondsPerSample);
                const double visit = frame >= fraction() ? frame : fraction() + frame;
                const double visits = std::ceil((plan_.seconds - cell.seconds()) / std::max(frame, fraction()) - 1e-9);
                const int rounds = plan_.rounds - round + (int(cell.runs.size()) < round ? 1 : 0);
                left += visit * std::clamp(visits, cell.measured() ? 0.0 : 1.0, double(rounds));
            }
        return left;
    }

    Device& device_;
    const Display& display_;
    const Plan& plan_;
    const WorkClock& now_;
    DeviceLoad& load_;
    const OnMeasurement& onMeasurement_;
    std::stop_token stop_;
    Measured& measured_;
    std::vector<Scene> scenes_;
};

}  // namespace

std::uint64_t Cell::frames() const {
    std::uint64_t sum = 0;
    for (const Run& run : runs)
        sum += run.lap.frames;
    return sum;
}

double Cell::seconds() const {
    double sum = 0;
    for (const Run& run : runs)
        sum += run.lap.seconds;
    return sum;
}

Spread Cell::spread() const {
    if (!measured())
        return {std::nan(""), std::nan(""), std::nan("")};
    std::vector<double> times;
    for (const Run& run : runs)
        times.push_back(run.frameSeconds());
    std::ranges::sort(times);
    return {quantile(times, 0.25), quantile(times, 0.5), quantile(times, 0.75)};
}

std::optional<double> Cell::load() const {
    double sum = 0, seconds = 0;
    for (const Run& run : runs)
        if (run.load) {
            sum += *run.load * run.lap.seconds;
            seconds += run.lap.seconds;
        }
    if (!(seconds > 0))
        return std::nullopt;
    return sum / seconds;
}

Result<void> measure(Device& device, const Scene& scene, const Display& display, const Plan& plan, const WorkClock& now,
                     DeviceLoad& load, const OnMeasurement& onMeasurement, std::stop_token stop, Measured& measured) {
    Experiment experiment(device, display, plan, now, load, onMeasurement, stop, measured);
    if (Result<void> prepared = experiment.prepare(scene); !prepared)
        return prepared;
    for (int round = 1; round <= plan.rounds && !stop.stop_requested(); ++round) {
        measured.rounds = round;
        if (Result<void> done = experiment.round(round); !done)
            return done;
    }
    measured.complete = !stop.stop_requested();
    return {};
}

}  // namespace pdr::bench::paper
