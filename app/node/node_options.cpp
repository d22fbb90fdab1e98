#include "app/node/node_options.h"

#include <QCommandLineParser>
#include <QSysInfo>

#include "app/command_line/option_reader.h"

namespace pdr::node {
namespace {

using app::Reader;
using app::usageError;

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription(
        "Takes samples for images of PD-Render on another machine. Nothing is written to disk; scans are kept in "
        "memory and wiped when the other machine says goodbye. Not for diagnostic use.");
    parser.addOptions({
        {{"h", "help"}, "Show this text."},
        {{"v", "version"}, "Say which version this is."},
        {"coordinator", "Dial the program that shows or writes the image. PDR_COORDINATOR.", "HOST[:PORT]"},
        {"listen", "Or wait for it to dial. PDR_LISTEN.", "[HOST:]PORT"},
        {"bundle",
         "The folder with this node's ca.pem, certificate.pem and key.pem. Without it only this machine can "
         "be talked to. PDR_BUNDLE.",
         "DIR"},
        {"relay", "Share all work with nodes that dial this address, and check what they send. PDR_RELAY.",
         "[HOST:]PORT"},
        {"relay-bundle", "With --relay: the folder of a coordinator's certificates, for them. PDR_RELAY_BUNDLE.",
         "DIR"},
        {"check",
         "With --relay: how much of what nodes send is rendered again by another machine: some (default; 2 %) or all, "
         "before it is used, which takes twice the work. PDR_CHECK.",
         "some|all"},
        {"name", "What users see; default: the name of this machine. PDR_NAME.", "NAME"},
        {"device",
         "What renders: auto (default; a GPU where there is one, else the CPU), cpu, cuda, cuda:1, ... "
         "PDR_DEVICE.",
         "NAME"},
        {"threads", "Of the CPU; default: one per core. PDR_THREADS.", "N"},
        {"coordinators",
         "With --listen: work for N programs at a time, in equal shares; more wait in line. Default 4. "
         "PDR_COORDINATORS.",
         "N"},
        {"idle-minutes", "End after N minutes without work; default: never. PDR_IDLE_MINUTES.", "N"},
        {"drain-seconds",
         "When it is to end (SIGTERM, SIGINT), take so long at most to finish; default 8. "
         "PDR_DRAIN_SECONDS.",
         "S"},
        {"give-up-seconds", "End when no coordinator could be reached for so long; default 120. PDR_GIVE_UP_SECONDS.",
         "S"},
        {"make-certificates", "Write certificates for a coordinator and for nodes into DIR, and end.", "DIR"},
        {"nodes",
         "With --make-certificates: write a certificate for each of N nodes, so that one can be shut out; default: "
         "one for all.",
         "N"},
    });
}

/// Returns the command line, followed by the environment's values of options that are not on it.
QStringList withEnvironment(QStringList arguments, const QCommandLineParser& parser,
                            const std::function<QString(const char*)>& environment) {
    for (const char* name : {"coordinator", "listen", "bundle", "name", "relay", "relay-bundle", "check", "device",
                             "threads", "coordinators", "idle-minutes", "drain-seconds", "give-up-seconds"}) {
        const QByteArray variable = "PDR_" + QByteArray(name).toUpper().replace('-', '_');
        const QString value = environment(variable.constData());
        const bool isRival = (QByteArray(name) == "listen" && parser.isSet("coordinator")) ||
                             (QByteArray(name) == "coordinator" && parser.isSet("listen"));
        if (!value.isEmpty() && !parser.isSet(name) && !isRival)
            arguments << "--" + QString(name) << value;
    }
    return arguments;
}

remote::Address orUsage(const char* option, const Result<remote::Address>& address) {
    if (!address)
        usageError(option, address.error().what, address.error().hint);
    return *address;
}

NodeOptions read(const QCommandLineParser& parser) {
    const Reader reader(parser);
    NodeOptions options;
    options.help = parser.isSet("help");
    options.version = parser.isSet("version");
    options.makeCertificates = reader.text("make-certificates").value_or("");
    options.certificates = int(reader.whole("nodes", 1, 10'000).value_or(0));
    if (options.certificates > 0 && options.makeCertificates.isEmpty())
        usageError("--nodes", "says for how many nodes --make-certificates writes certificates");
    if (options.help || options.version || !options.makeCertificates.isEmpty())
        return options;
    if (const auto text = reader.text("coordinator"))
        options.coordinator = orUsage("--coordinator", remote::parseAddress(*text));
    if (const auto text = reader.text("listen"))
        options.listen = orUsage("--listen", remote::parseListening(*text));
    if (options.coordinator.has_value() == options.listen.has_value())
        usageError("--coordinator", "either this or --listen is needed");
    options.bundle = reader.text("bundle").value_or("");
    options.relay = reader.text("relay").value_or("");
    options.relayBundle = reader.text("relay-bundle").value_or("");
    if (!options.relayBundle.isEmpty() && options.relay.isEmpty())
        usageError("--relay-bundle", "is for the nodes that --relay waits for");
    if (const auto check = reader.text("check")) {
        if (*check != "some" && *check != "all")
            usageError("--check", "must be some or all");
        if (options.relay.isEmpty())
            usageError("--check", "is for the nodes that --relay waits for");
        options.checksAll = *check == "all";
    }
    options.name = reader.text("name").value_or(QSysInfo::machineHostName()).left(32);
    options.device = reader.text("device").value_or("auto").toStdString();
    options.threads = int(reader.whole("threads", 0, 1024).value_or(0));
    options.coordinators = int(reader.whole("coordinators", 1, 64).value_or(std::uint64_t(options.coordinators)));
    if (!options.relay.isEmpty() && parser.isSet("coordinators") && options.coordinators > 1)
        usageError("--coordinators", "must be 1 with --relay", "A relay works for one program at a time.");
    if (!options.relay.isEmpty())
        options.coordinators = 1;
    options.idle = std::chrono::minutes(reader.whole("idle-minutes", 0, 100000).value_or(0));
    options.drain = std::chrono::seconds(reader.whole("drain-seconds", 0, 3600).value_or(8));
    options.giveUp = std::chrono::seconds(reader.whole("give-up-seconds", 1, 1000000).value_or(120));
    return options;
}

}  // namespace

Result<NodeOptions> nodeOptions(const QStringList& arguments, const std::function<QString(const char*)>& environment) {
    const auto parse = [](QCommandLineParser& parser, const QStringList& all) {
        describe(parser);
        if (!parser.parse(QStringList("pdrender-node") + all))
            throw Error{parser.errorText().toStdString(), "", ""};
        if (!parser.positionalArguments().isEmpty())
            usageError(parser.positionalArguments().first(), "is no option");
    };
    try {
        QCommandLineParser given, all;
        parse(given, arguments);
        parse(all, withEnvironment(arguments, given, environment));
        return read(all);
    } catch (const Error& error) {
        return error;
    }
}

std::string nodeHelp() {
    QCommandLineParser parser;
    describe(parser);
    parser.parse({"pdrender-node"});
    return parser.helpText().toStdString() +
           "\nExit codes: 0 drained, or idle for as long as was said; 64 wrong usage; 69 no coordinator can be "
           "reached;\n70 internal error; 75 the device failed; 76 another version of the protocol; 77 turned away;\n"
           "78 wrong certificates or addresses.\n";
}

}  // namespace pdr::node
