#include "app/cli/cluster/slurm_job.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>

static void initResources() {  // outside of any namespace, as Qt requires
    Q_INIT_RESOURCE(resources);
}

namespace pdr::app {
namespace {

constexpr int kPatienceMs = 60'000;

QByteArray batchScript() {
    initResources();
    QFile script(":/slurm/pdrender-node.sbatch");
    return script.open(QIODevice::ReadOnly) ? script.readAll() : QByteArray();
}

/// Returns the environment of sbatch, which Slurm passes on to the nodes.
QProcessEnvironment environment(const ClusterOptions& options, const remote::Address& coordinator) {
    QProcessEnvironment known = QProcessEnvironment::systemEnvironment();
    known.insert("PDR_COORDINATOR", coordinator.text());
    if (!options.nodeBundle.isEmpty())
        known.insert("PDR_BUNDLE", options.nodeBundle);
    known.insert("PDR_GIVE_UP_SECONDS", QString::number(options.keepSeconds));
    known.insert("PDR_IDLE_MINUTES", QString::number(options.idleMinutes));
    const QString beside = QDir(QCoreApplication::applicationDirPath()).filePath("pdrender-node");
    if (!known.contains("PDR_NODE_PROGRAM") && QFile::exists(beside))
        known.insert("PDR_NODE_PROGRAM", beside);
    return known;
}

}  // namespace

Result<QString> submitNodes(const ClusterOptions& options, const remote::Address& coordinator) {
    QProcess sbatch;
    sbatch.setProcessEnvironment(environment(options, coordinator));
    sbatch.start("sbatch", QStringList{"--parsable", QString("--array=0-%1").arg(options.nodes - 1)} + options.sbatch);
    if (!sbatch.waitForStarted())
        return Error{"Slurm's sbatch cannot be started", "sbatch", "Use a machine from which jobs are submitted."};
    sbatch.write(batchScript());
    sbatch.closeWriteChannel();
    if (!sbatch.waitForFinished(kPatienceMs))
        return Error{"Slurm does not answer", "sbatch", "Try again later."};
    const QString said = QString::fromUtf8(sbatch.readAllStandardOutput()).trimmed();
    if (sbatch.exitStatus() != QProcess::NormalExit || sbatch.exitCode() != 0 || said.isEmpty())
        return Error{QString::fromUtf8(sbatch.readAllStandardError()).trimmed().toStdString(), "sbatch", ""};
    return said.section(';', 0, 0);  // "17", or "17;cluster"
}

}  // namespace pdr::app
