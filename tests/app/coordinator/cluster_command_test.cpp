#include <QtTest>

#include <QTemporaryDir>

#include "app/cli/cluster/cluster_options.h"
#include "tests/support/program_run.h"

using namespace pdr;
using namespace pdr::app;

namespace {

/// Takes the place of Slurm's: keeps what it is given, and starts the nodes itself.
constexpr const char* kSbatch = R"(#!/usr/bin/env bash
folder=$(dirname "$0")
cat >"$folder/script"
printf '%s\n' "$@" >"$folder/words"
[ ! -e "$folder/refuses" ] || { echo "Batch job submission failed: no partition" >&2; exit 1; }
for node in 1 2; do
    "$PDR_NODE_PROGRAM" --name "acted-$node" --device cpu --threads 1 </dev/null >/dev/null 2>&1 &
done
echo "17;cluster"
)";

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// A folder with that sbatch and certificates.
struct Place {
    Place() {
        QFile sbatch(folder.filePath("sbatch"));
        if (!sbatch.open(QIODevice::WriteOnly) || sbatch.write(kSbatch) < 0)
            qFatal("no sbatch");
        sbatch.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        test::runProgram("pdrender-node", {"--make-certificates", folder.filePath("certificates")});
    }
    test::ProgramRun cluster(const QStringList& words) const {
        return test::runProgram("pdrender-cli", QStringList{"cluster"} + words, [this](QProcess& process) {
            QProcessEnvironment known = QProcessEnvironment::systemEnvironment();
            known.insert("PATH", folder.path() + ":" + known.value("PATH"));
            process.setProcessEnvironment(known);
        });
    }
    QStringList start(int nodes) const {
        return {"start",
                "--slurm",
                QString::number(nodes),
                "--listen",
                "127.0.0.1:0",
                "--bundle",
                folder.filePath("certificates/coordinator"),
                "--keep-seconds",
                "1"};
    }

    QTemporaryDir folder;
};

std::string told(const QStringList& arguments) {
    const auto options = clusterOptions(arguments);
    return options ? "" : options.error().text();
}

bool says(const std::string& text, const char* words) {
    return text.find(words) != std::string::npos;
}

}  // namespace

class ClusterCommandTest : public QObject {
    Q_OBJECT

  private slots:
    void nodesAreSubmittedAndAwaited() {
        const Place place;
        const test::ProgramRun run = place.cluster(place.start(2) + QStringList{"--", "--partition=gpu"});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(run.err.contains("node acted-1 (") && run.err.contains("node acted-2 ("));
        QVERIFY(run.out.contains("2 nodes of job 17 are there") && run.out.contains("scancel 17"));
        QCOMPARE(contents(place.folder.filePath("script")),
                 contents(PDR_SOURCE_DIR "/installer/slurm/pdrender-node.sbatch"));
        QCOMPARE(contents(place.folder.filePath("words")), QByteArray("--parsable\n--array=0-1\n--partition=gpu\n"));
    }

    void whoDoesNotComeInTimeIsTold() {
        const Place place;
        const test::ProgramRun run = place.cluster(place.start(3) + QStringList{"--wait-seconds", "2"});
        QCOMPARE(run.code, 1);
        QVERIFY(run.err.contains("not all nodes of job 17 came") && run.err.contains("scancel 17"));
    }

    void whatSlurmSaysIsTold() {
        const Place place;
        QFile(place.folder.filePath("refuses")).open(QIODevice::WriteOnly);
        const test::ProgramRun run = place.cluster(place.start(2));
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("no partition"), run.err.constData());
    }

    void wrongWordsAreNamed() {
        QVERIFY(says(told({}), "cluster start"));
        QVERIFY(says(told({"stop"}), "cluster start"));
        QVERIFY(says(told({"start", "--listen", "4743"}), "--slurm"));
        QVERIFY(says(told({"start", "--slurm", "0", "--listen", "4743"}), "--slurm"));
        QVERIFY(says(told({"start", "--slurm", "2"}), "--listen"));
        QVERIFY(says(told({"start", "--slurm", "2", "--listen", "1", "--bundle", "/none/such"}), "/none/such"));
        const auto options =
            clusterOptions({"start", "--slurm", "2", "--listen", "4743", "--", "--gres=gpu:1", "-p", "x"});
        QVERIFY(options);
        QCOMPARE(options->sbatch, (QStringList{"--gres=gpu:1", "-p", "x"}));
        QVERIFY(clusterOptions({"--help"})->help);
    }
};

QTEST_GUILESS_MAIN(ClusterCommandTest)
#include "cluster_command_test.moc"
