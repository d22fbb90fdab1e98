/// Measures the speedup by render nodes, as programs on this machine, each pinned to a core of its own.
///   node_speed [--size WxH] [--samples N] [--rounds N] [--nodes N] [--model NAME]
/// Each round renders the same frame of N samples (default 100, at 1920x1080) by the local device with one thread and
/// with as many as there are nodes, by one node, and by all nodes (default 2); nodes take everything, and the local
/// device audits. All ways alternate, so that load on the machine affects all. Prints a line each: seconds of each
/// round, iterations a second (median); then ratios of the medians: one node against one thread (the cost of the
/// protocol), all nodes against one, and all threads against one, which is the most that this machine could reach.

#include <sched.h>

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "render/volume/phantom.h"
#include "tests/support/network/shared_image.h"

namespace pdr::test {
namespace {

Scene speedScene(ivec2 size, Model model) {
    Scene scene = plainScene(std::make_shared<Volume>(headPhantom({128, 115, 128}, {1.95, 2.8, 1.95})), 4);
    scene.transferFunction.nodes = {{.hu = 200, .opacity = 0},
                                    {.hu = 1200, .opacity = 1, .albedo = vec3(0.9f, 0.85f, 0.75f)}};
    scene.environment.radiance = vec3(0.3f);
    scene.model = model;
    const VolumeGeometry& geometry = scene.volume->geometry();
    scene.camera =
        standardView(StandardView::anterior, geometry.centreMm(), geometry.radiusMm(), double(size.x) / double(size.y));
    scene.film = size;
    return scene;
}

/// Pins all threads of a process, and so those that they start.
void pin(qint64 process, int core) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(core, &set);
    const QDir threads(QString("/proc/%1/task").arg(process));
    for (const QString& thread : threads.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        if (sched_setaffinity(pid_t(thread.toInt()), sizeof set, &set) != 0)
            qFatal("a node cannot be kept to one core");
}

/// Seconds of a frame. The scene must be on the device, and its workers ready.
double frameSeconds(Accumulator& film, std::uint32_t samples) {
    if (!film.restart(film.area(), 0))
        qFatal("the film cannot be emptied");
    const auto start = std::chrono::steady_clock::now();
    for (std::uint32_t done = 0; done < samples;) {
        const std::uint32_t n = std::min(samples - done, film.orderSize().samples);
        if (const auto taken = film.accumulate(n, {}); !taken)
            qFatal("%s", taken.error().text().c_str());
        done += n;
    }
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

double told(const char* way, const std::vector<double>& seconds, std::uint32_t samples) {
    std::printf("%-16s", way);
    for (const double one : seconds)
        std::printf(" %7.2f s", one);
    const double rate = samples / median(seconds);
    std::printf("   %.3f iterations/s\n", rate);
    return rate;
}

struct Crew {
    NodeTrial trial;
    NodeProcesses processes;
    std::unique_ptr<Accumulator> film;

    Crew(int count, const Scene& scene) : processes(startNodes(count)) {
        trial.pool->setOwnHelps(false);
        for (int i = 0; i < count; ++i) {
            pin(processes[std::size_t(i)]->id(), i);
            trial.add(*processes[std::size_t(i)]);
        }
        film = *startFilm(*trial.device, scene);
        trial.awaitReady(count);
        while (std::ranges::any_of(trial.pool->workers(), [](const WorkerStatus& one) { return !one.isProved; }))
            if (!film->accumulate(1, {}))  // until they are trusted
                qFatal("the nodes cannot be made ready");
    }
};

int run() {
    QCommandLineParser parser;
    parser.addOptions({{"size", "", "WxH", "1920x1080"},
                       {"samples", "", "N", "100"},
                       {"rounds", "", "N", "3"},
                       {"nodes", "", "N", "2"},
                       {"model", "", "NAME", "singleScattering"}});
    parser.process(*QCoreApplication::instance());
    const QStringList size = parser.value("size").split('x');
    const auto samples = std::uint32_t(parser.value("samples").toUInt());
    const auto* model = std::ranges::find(kModels, parser.value("model").toStdString(), modelName);
    const Scene scene = speedScene({size.value(0).toInt(), size.value(1).toInt()}, *model);
    const int nodes = parser.value("nodes").toInt();
    const auto oneThread = makeCpuDevice(1), allThreads = makeCpuDevice(nodes);
    const auto thread = *startFilm(*oneThread, scene), threads = *startFilm(*allThreads, scene);
    Crew one(1, scene), all(nodes, scene);
    std::vector<double> threadSeconds, threadsSeconds, oneSeconds, allSeconds;
    for (int round = 0; round < parser.value("rounds").toInt(); ++round) {
        threadSeconds.push_back(frameSeconds(*thread, samples));
        threadsSeconds.push_back(frameSeconds(*threads, samples));
        oneSeconds.push_back(frameSeconds(*one.film, samples));
        allSeconds.push_back(frameSeconds(*all.film, samples));
    }
    const double threadRate = told("one thread", threadSeconds, samples);
    const double threadsRate = told("all threads", threadsSeconds, samples);
    const double oneRate = told("one node", oneSeconds, samples), allRate = told("all nodes", allSeconds, samples);
    std::printf("one node against one thread: %.3f; all nodes against one: %.2f; all threads against one: %.2f\n",
                oneRate / threadRate, allRate / oneRate, threadsRate / threadRate);
    return 0;
}

}  // namespace
}  // namespace pdr::test

int main(int argc, char** argv) {
    const QCoreApplication application(argc, argv);
    return pdr::test::run();
}
