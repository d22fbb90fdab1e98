#include "app/cli/scene/looks_command.h"

#include <cstdio>

#include "app/cli/failed.h"
#include "app/looks/looks.h"
#include "render/scene/fields/named_look_fields.h"

namespace pdr::app {
namespace {

constexpr const char* kHelp =
    "pdrender-cli looks\n"
    "\n"
    "Lists the looks that --look takes, by group, with the scans that they are meant for and what they do not show.\n";

std::string groupName(LookGroup group) {
    for (const auto& [word, meaning] : kLookGroupWords)
        if (meaning == group)
            return std::string(word);
    return "";
}

/// Returns the scans that a look is meant for: "with lungs, without contrast in the blood"; empty: any scan.
std::string meantFor(const Suits& suits) {
    std::string text;
    const auto add = [&](std::optional<bool> wanted, const char* what) {
        if (wanted)
            text += (text.empty() ? "" : ", ") + std::string(*wanted ? "with " : "without ") + what;
    };
    add(suits.trunk, "a trunk");
    add(suits.lungs, "lungs");
    add(suits.contrast, "contrast in the blood");
    add(suits.metal, "metal in the body");
    return text;
}

}  // namespace

int runLooks(const QStringList& arguments) {
    if (arguments.contains("--help") || arguments.contains("-h")) {
        std::fputs(kHelp, stdout);
        return 0;
    }
    if (!arguments.isEmpty()) {
        std::fprintf(stderr, "usage: %s", kHelp);
        return 2;
    }
    const auto looks = bundledLooks();
    if (!looks)
        return failed(looks.error());
    for (const NamedLook& look : *looks) {
        const std::string scans = meantFor(look.suits);
        std::printf("%s (%s%s%s)\n    %s\n", look.name.c_str(), groupName(look.group).c_str(),
                    scans.empty() ? "" : "; scans ", scans.c_str(), look.doesNotShow.c_str());
    }
    return 0;
}

}  // namespace pdr::app
