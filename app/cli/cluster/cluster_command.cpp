#include "app/cli/cluster/cluster_command.h"

#include <QElapsedTimer>
#include <QEventLoop>
#include <QSysInfo>
#include <QTimer>
#include <cstdio>
#include <set>

#include "app/cli/cluster/cluster_options.h"
#include "app/cli/cluster/slurm_job.h"
#include "app/cli/run_command.h"
#include "app/coordinator/render_nodes.h"
#include "app/program/interrupt.h"
#include "render/device/device_list.h"
#include "render/tiles/reference_tiles.h"
#include "render/tiles/worker_pool.h"

namespace pdr::app {
namespace {

using nodes::NodeStatus;
using nodes::RenderNodes;

constexpr int kLookMs = 50;

void say(const QString& line) {
    std::fprintf(stderr, "%s\n", line.toUtf8().constData());
}

/// Waits until `wanted` nodes are connected at the same time. Returns false if the time is up or `stop` comes first.
bool await(RenderNodes& nodes, int wanted, int seconds, const std::stop_token& stop) {
    std::set<nodes::NodeId> there;
    QEventLoop loop;
    QObject::connect(&nodes, &RenderNodes::joined, &loop, [&](const NodeStatus& node) {
        say(QString("node %1 (%2) is there").arg(node.name, node.device));
        there.insert(node.id);
        if (int(there.size()) >= wanted)
            loop.quit();
    });
    QObject::connect(&nodes, &RenderNodes::lost, &loop, [&](const NodeStatus& node) {
        say(QString("node %1 is lost: %2").arg(node.name, QString::fromStdString(node.reason)));
        there.erase(node.id);
    });
    QTimer look;
    QElapsedTimer waiting;
    waiting.start();
    QObject::connect(&look, &QTimer::timeout, &loop, [&] {
        if (stop.stop_requested() || waiting.elapsed() > 1000LL * seconds)
            loop.quit();
    });
    look.start(kLookMs);
    loop.exec();
    return int(there.size()) >= wanted;
}

void sayHowToGoOn(const ClusterOptions& options, const QString& job, double seconds) {
    const QString bundle = options.bundle.isEmpty() ? "" : " --bundle " + options.bundle;
    std::printf(
        "%d nodes of job %s are there after %.1f s. They wait %d s for the program that renders with them:\n"
        "  pdrender-cli render FOLDER -o image.png --listen %s%s --await %d\n"
        "They end when they have been idle for %d minutes, or by: scancel %s\n",
        options.nodes, qUtf8Printable(job), seconds, options.keepSeconds, qUtf8Printable(options.listen),
        qUtf8Printable(bundle), options.nodes, options.idleMinutes, qUtf8Printable(job));
}

/// Returns the address at which nodes dial this machine, which listens at `listening`.
remote::Address dialled(const ClusterOptions& options, remote::Address listening) {
    if (!options.host.isEmpty())
        listening.host = options.host;
    else if (listening.host.isEmpty() || listening.host == "0.0.0.0" || listening.host == "::")
        listening.host = QSysInfo::machineHostName();
    return listening;
}

Result<void> start(const ClusterOptions& options, const std::stop_token& stop) {
    const auto device = openDevice("cpu");
    if (!device)
        return device.error();
    const auto bits = referenceTiles(**device);
    if (!bits)
        return bits.error();
    // Listen first: the job needs the address of this machine
    RenderNodes nodes(std::make_shared<WorkerPool>(0), *bits);
    nodes.setBundle(options.bundle);
    const auto listening = nodes.listen(options.listen);
    if (!listening)
        return listening.error();
    QElapsedTimer took;
    took.start();
    // Submit the job and wait for its nodes
    const auto job = submitNodes(options, dialled(options, *listening));
    if (!job)
        return job.error();
    say(QString("job %1 is submitted; waiting for its nodes at %2").arg(*job, listening->text()));
    if (!await(nodes, options.nodes, options.waitSeconds, stop))
        return Error{"not all nodes of job " + job->toStdString() + " came", "",
                     "Look at what they say (slurm-" + job->toStdString() + "_0.out), or end them by: scancel " +
                         job->toStdString()};
    sayHowToGoOn(options, *job, 1e-3 * double(took.elapsed()));
    return {};
}

}  // namespace

int runCluster(const QStringList& arguments) {
    return runCommand("cluster", clusterOptions(arguments), clusterHelp, [](const ClusterOptions& options) {
        const Interrupt interrupt;
        const Result<void> done = start(options, interrupt.token());
        return done ? 0 : failed(done.error());
    });
}

}  // namespace pdr::app
