/// pdrender-node renders samples for images of other machines. Exit codes: exit_codes.h.

#include <malloc.h>

#include <QCoreApplication>
#include <QTimer>
#include <cstdio>
#include <optional>

#include "app/node/introduction.h"
#include "app/node/node_service.h"
#include "app/node/relay.h"
#include "app/program/interrupt.h"
#include "app/program/program.h"
#include "app/remote/certificates.h"
#include "render/base/version.h"
#include "render/device/device_list.h"
#include "render/tiles/reference_tiles.h"

namespace pdr::node {
namespace {

int ending(const Error& error, ExitCode code) {
    std::fprintf(stderr, "pdrender-node: %s\n", error.text().c_str());
    return int(code);
}

int makeBundle(const QString& folder, int nodes) {
    if (const Result<void> made = remote::makeCertificates(folder, nodes); !made)
        return ending(made.error(), ExitCode::configuration);
    const QByteArray where = folder.toUtf8();
    const QByteArray ofNodes = nodes == 0 ? "/node goes to all nodes" : "/node-1, node-2, ... go to one node each";
    std::printf(
        "certificates: %s/coordinator stays on the machine that shows the image, %s%s.\n"
        "Keep the keys secret: who has one can take part.\n",
        where.constData(), where.constData(), ofNodes.constData());
    return 0;
}

void log(const QString& line) {
    std::fprintf(stderr, "pdrender-node: %s\n", line.toUtf8().constData());
}

/// Returns the relay that the options ask for, which waits for nodes; null: they ask for none.
Result<std::unique_ptr<Relay>> relayFor(const NodeOptions& options, Device& device) {
    if (options.relay.isEmpty())
        return std::unique_ptr<Relay>();
    const Result<std::vector<std::byte>> tiles = referenceTiles(device);
    if (!tiles)
        return tiles.error();
    auto relay = std::make_unique<Relay>(*tiles);
    QObject::connect(relay.get(), &Relay::said, log);
    if (const Result<void> listens = relay->listen(options); !listens)
        return listens.error();
    return relay;
}

int work(const NodeOptions& options, const app::Interrupt& interrupt) {
    // Open a device and render its reference tiles
    NodeService* running = nullptr;
    std::optional<Error> instead;
    const WhySpare goOnOnCpu = [&](const Error& why) {
        std::fprintf(stderr, "pdrender-node: the CPU renders, since a GPU cannot: %s\n", why.text().c_str());
        if (running)
            return running->goOnInstead(why);
        instead = why;
    };
    const PreparationObserver preparing = [](bool begins) {
        std::fprintf(stderr, "pdrender-node: %s\n", begins ? "preparing the GPU..." : "the GPU is prepared");
    };
    const OpenDevice open = [&] {
        return openDeviceToTheEnd(instead ? "cpu" : options.device, options.threads, goOnOnCpu, preparing);
    };
    Result<std::unique_ptr<Device>> device = open();
    if (!device)
        return ending(device.error(), ExitCode::configuration);
    const Result<wire::Hello> hello = introduction(options, **device, instead);
    if (!hello)
        return ending(hello.error(), ExitCode::temporary);
    const Result<std::unique_ptr<Relay>> relay = relayFor(options, **device);
    if (!relay)
        return ending(relay.error(), ExitCode::configuration);
    device->reset();
    // Connect the service to the log, the exit code and signals
    NodeService service(options, *hello, *relay ? (*relay)->sharing(open) : open);
    running = &service;
    QObject::connect(&service, &NodeService::said, log);
    int code = int(ExitCode::internal);
    QObject::connect(&service, &NodeService::finished, [&code](ExitCode why) {
        code = int(why);
        // Leave time to send the last messages.
        QTimer::singleShot(100, QCoreApplication::instance(), &QCoreApplication::quit);
    });
    QTimer signal;
    QObject::connect(&signal, &QTimer::timeout, &service, [&] {
        if (interrupt.token().stop_requested())
            service.drain();
    });
    signal.start(50);
    // Run until the service finishes
    if (const Result<void> started = service.start(); !started)
        return ending(started.error(), ExitCode::configuration);
    QCoreApplication::exec();
    return code;
}

int run() {
    const app::Interrupt interrupt;
    const Result<NodeOptions> options =
        nodeOptions(QCoreApplication::arguments().mid(1), [](const char* name) { return qEnvironmentVariable(name); });
    if (!options) {
        ending(options.error(), ExitCode::usage);
        std::fputs("\"pdrender-node --help\" lists all options.\n", stderr);
        return int(ExitCode::usage);
    }
    if (options->help) {
        std::fputs(nodeHelp().c_str(), stdout);
        return 0;
    }
    if (options->version) {
        std::puts("PD-Render " PDR_VERSION);
        return 0;
    }
    return options->makeCertificates.isEmpty() ? work(*options, interrupt)
                                               : makeBundle(options->makeCertificates, options->certificates);
}

}  // namespace
}  // namespace pdr::node

int main(int argc, char** argv) {
    mallopt(M_PERTURB, 0x5a);  // overwrite freed memory: it may have held a scan
    const int code = pdr::app::runProgram("pdrender-node", [&] {
        const QCoreApplication application(argc, argv);
        pdr::app::keepNumbersPlain();
        return pdr::node::run();
    });
    return code == 1 ? int(pdr::node::ExitCode::internal) : code;
}
