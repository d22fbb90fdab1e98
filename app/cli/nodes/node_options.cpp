#include "app/cli/nodes/node_options.h"

#include "app/command_line/option_reader.h"

namespace pdr::app {

void describeNodeOptions(QCommandLineParser& parser) {
    parser.addOptions({
        {"node", "Let the render node at this address help; may be given several times.", "HOST[:PORT]"},
        {"listen", "Let render nodes help that dial this machine.", "[HOST:]PORT"},
        {"bundle",
         "The folder of certificates for connections to other machines (pdrender-node --make-certificates); without it "
         "nodes must be on this one.",
         "DIR"},
        {"await", "Begin when N nodes are ready; default: at once, and nodes join as they come.", "N"},
        {"await-seconds", "End without an image when these N are not ready after S seconds; default 120.", "S"},
        {"nodes-only", "This machine only checks what nodes send, as long as there is one."},
        {"check",
         "How much of what nodes send is rendered again by another machine: some (default; 2 %) or all, before it is "
         "used, which takes twice the work.",
         "some|all"},
        {"split",
         "How the image is shared out: tiles (each a part of it) or samples (each all of it, in blocks of 64 "
         "samples). Default: what a model of their costs finds faster.",
         "WORD"},
    });
}

NodesWanted readNodeOptions(const QCommandLineParser& parser) {
    const Reader reader(parser);
    NodesWanted nodes;
    nodes.nodes = parser.values("node");
    nodes.listen = reader.text("listen");
    nodes.bundle = reader.text("bundle").value_or("");
    nodes.await = int(reader.whole("await", 0, 100000).value_or(0));
    nodes.awaitSeconds = int(reader.whole("await-seconds", 1, 1'000'000).value_or(std::uint64_t(nodes.awaitSeconds)));
    nodes.nodesOnly = parser.isSet("nodes-only");
    if (const auto check = reader.text("check")) {
        if (*check != "some" && *check != "all")
            usageError("--check", "must be some or all");
        nodes.checksAll = *check == "all";
    }
    if (const auto split = reader.text("split")) {
        if (*split != "tiles" && *split != "samples")
            usageError("--split", "must be tiles or samples");
        nodes.split = *split == "tiles" ? Split::tiles : Split::samples;
    }
    for (const char* option : {"bundle", "await", "await-seconds", "nodes-only", "check", "split"})
        if (parser.isSet(option) && !nodes.any())
            usageError(QString("--") + option, "is for render nodes, and none are named", "Add --node or --listen.");
    return nodes;
}

}  // namespace pdr::app
