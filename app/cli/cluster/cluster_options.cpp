#include "app/cli/cluster/cluster_options.h"

#include <QCommandLineParser>
#include <QDir>
#include <QSysInfo>

#include "app/command_line/option_reader.h"

namespace pdr::app {
namespace {

constexpr const char* kHelp =
    "pdrender-cli cluster start --slurm N --listen [HOST:]PORT --bundle DIR [options] [-- WORDS FOR SBATCH]\n"
    "\n"
    "Submits a job of N render nodes to Slurm, waits until all have dialled this machine, and says how to render with "
    "them.\n"
    "They go on dialling for a while, so that the program that renders can listen in the place of this one.\n"
    "\n"
    "  --slurm N              nodes, from 1: the tasks of an array\n"
    "  --listen [HOST:]PORT   where they dial\n"
    "  --bundle DIR           this machine's certificates (pdrender-node --make-certificates)\n"
    "  --node-bundle DIR      theirs, where they can read them; default: the folder \"node\" beside DIR\n"
    "  --host NAME            by which they know this machine; default: HOST, or this machine's name\n"
    "  --wait-seconds S       for all of them; default 300\n"
    "  --keep-seconds S       that they go on dialling while nobody listens; default 600\n"
    "  --idle-minutes N       without work, before they end; default 10\n"
    "\n"
    "  pdrender-cli cluster start --slurm 8 --listen 4743 --bundle certificates/coordinator -- --gres=gpu:1\n";

void describe(QCommandLineParser& parser) {
    parser.addOptions({{{"h", "help"}, ""},
                       {"slurm", "", "N"},
                       {"listen", "", "ADDRESS"},
                       {"bundle", "", "DIR"},
                       {"node-bundle", "", "DIR"},
                       {"host", "", "NAME"},
                       {"wait-seconds", "", "S"},
                       {"keep-seconds", "", "S"},
                       {"idle-minutes", "", "N"}});
    parser.addPositionalArgument("words", "");
}

QString folder(const char* option, const QString& path) {
    if (!QDir(path).exists())
        usageError(option, "there is no folder " + path.toStdString(),
                   "pdrender-node --make-certificates DIR makes certificates.");
    return QDir(path).absolutePath();
}

ClusterOptions read(const QCommandLineParser& parser) {
    const Reader reader(parser);
    ClusterOptions options;
    options.help = parser.isSet("help");
    if (options.help)
        return options;
    QStringList words = parser.positionalArguments();
    if (words.isEmpty() || words.takeFirst() != "start")
        usageError("cluster", "say \"cluster start\"");
    options.sbatch = words;
    options.nodes = int(reader.whole("slurm", 1, 10'000).value_or(0));
    if (options.nodes == 0)
        usageError("--slurm", "is needed: how many nodes there are to be");
    options.listen = reader.text("listen").value_or("");
    if (options.listen.isEmpty())
        usageError("--listen", "is needed: where the nodes dial");
    options.host = reader.text("host").value_or("");
    if (const auto bundle = reader.text("bundle")) {
        options.bundle = folder("--bundle", *bundle);
        options.nodeBundle =
            folder("--node-bundle", reader.text("node-bundle").value_or(QDir(*bundle).filePath("../node")));
    }
    options.waitSeconds = int(reader.whole("wait-seconds", 1, 1'000'000).value_or(300));
    options.keepSeconds = int(reader.whole("keep-seconds", 1, 1'000'000).value_or(600));
    options.idleMinutes = int(reader.whole("idle-minutes", 0, 100'000).value_or(10));
    return options;
}

}  // namespace

Result<ClusterOptions> clusterOptions(const QStringList& arguments) {
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(QStringList("pdrender-cli cluster") + arguments))
        return Error{parser.errorText().toStdString(), "", ""};
    try {
        return read(parser);
    } catch (const Error& error) {
        return error;
    }
}

std::string clusterHelp() {
    return kHelp;
}

}  // namespace pdr::app
