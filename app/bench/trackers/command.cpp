#include <algorithm>
#include <cstdio>
#include <ctime>

#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "app/bench/trackers/scenes.h"
#include "app/bench/trackers/tracker.h"
#include "render/scene/scene.h"

namespace pdr::bench {

namespace {

/// One line of the table, per ray.
struct Row {
    std::optional<Work> work;  ///< work of all rays; null if it is not counted
    double nanoseconds = 0;
    double speed = 0;  ///< speed relative to the biased march in the same round
    double hits = 0;   ///< fraction of the rays that collide
};

/// Returns the time per ray on the core, which excludes other programs, over as many passes as make it long compared
/// with the resolution of the clock.
double nanosecondsPerRay(Tracker& tracker, const RayList& list) {
    constexpr std::clock_t kLong = CLOCKS_PER_SEC / 50;
    const std::clock_t start = std::clock();
    std::clock_t taken = 0;
    int passes = 0;
    do {
        tracker.hits(list);
        ++passes;
        taken = std::clock() - start;
    } while (taken < kLong);
    return 1e9 * double(taken) / CLOCKS_PER_SEC / passes / double(list.rays.size());
}

/// Measures all trackers. They take turns, round by round. Work is counted apart from time.
std::vector<Row> measured(const std::vector<std::unique_ptr<Tracker>>& trackers, const RayList& list, int rounds) {
    std::vector<Row> rows;
    rows.reserve(trackers.size());
    for (const auto& tracker : trackers)
        rows.push_back({.work = tracker->work(list), .hits = tracker->hits(list) / double(list.rays.size())});
    std::vector<std::vector<double>> times(trackers.size()), speeds(trackers.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < trackers.size(); ++i) {
            times[i].push_back(nanosecondsPerRay(*trackers[i], list));
            speeds[i].push_back(times[kMarch].back() / times[i].back());
        }
    for (std::size_t i = 0; i < trackers.size(); ++i) {
        rows[i].nanoseconds = median(times[i]);
        rows[i].speed = median(speeds[i]);
    }
    return rows;
}

void print(const std::string& name, const Row& row, double rays) {
    char fetches[16] = "-", cells[16] = "-";
    if (row.work) {
        std::snprintf(fetches, sizeof fetches, "%.1f", double(row.work->fetches) / rays);
        if (row.work->cells > 0)
            std::snprintf(cells, sizeof cells, "%.1f", double(row.work->cells) / rays);
    }
    std::printf("%-28s %9s %8s %9.0f %9.2f %9.4f\n", name.c_str(), fetches, cells, row.nanoseconds, row.speed,
                row.hits);
}

void compareTrackers(const std::string& name, const Scene& scene, int edge, int rounds) {
    const auto prepared = Flattener().prepare(scene);
    const RayList list = primaryRays(prepared->flat, edge);
    const auto trackers = allTrackers(*prepared);
    const std::vector<Row> rows = measured(trackers, list, rounds);
    const double rays = double(list.rays.size());
    const ivec3 size = scene.volume->size();
    std::printf("\n%s: %d x %d x %d voxels, %d x %d rays, medians of %d rounds\n", name.c_str(), size.x, size.y, size.z,
                edge, edge, rounds);
    std::printf("%-28s %9s %8s %9s %9s %9s\n", "per primary ray", "fetches", "cells", "ns", "speed", "hit");
    for (std::size_t i = 0; i < rows.size(); ++i)
        print(trackers[i]->name(), rows[i], rays);
    const auto fetches = [&](TrackerPlace place) { return double(rows[place].work->fetches); };
    std::printf(
        "ours: %.2f x as fast as the biased march; 1/%.0f of the fetches of the march of 0.05 voxels, "
        "1/%.0f of those behind one bound\n",
        rows[kTwoLevel].speed, fetches(kFineMarch) / fetches(kTwoLevel), fetches(kGlobal) / fetches(kTwoLevel));
    std::fflush(stdout);
}

}  // namespace

int trackers(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--rays", "--rounds"});
    const auto edge = options ? options->number("--rays", 96, 1) : std::nullopt;
    const auto rounds = options ? options->number("--rounds", 9, 1) : std::nullopt;
    if (!edge || !rounds)
        return 2;
    std::vector<NamedScene> scenes;
    for (const std::string& file : options->files) {
        Result<Scene> scene = loadScene(file);
        if (!scene)
            return fail(scene.error());
        scenes.push_back({file, *scene});
    }
    if (scenes.empty())
        scenes = headScenes();
    std::printf(
        "Trackers to the first collision, one ray at a time (the last one: lanes). Time of one core; \"speed\" is "
        "against the biased march.\n");
    for (const NamedScene& one : scenes)
        compareTrackers(one.name, one.scene, *edge, *rounds);
    return 0;
}

}  // namespace pdr::bench
