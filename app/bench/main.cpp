/// pdrender-bench: measures the renderer alone. No window, no DICOM, so that it also runs on a bare machine with a GPU.

#include <cstdio>
#include <map>

#include "app/bench/commands.h"

int main(int argc, char** argv) {
    using namespace pdr::bench;
    static const std::map<std::string, int (*)(const Arguments&)> commands{
        {"picture", picture}, {"frames", frames},         {"compare", compare},
        {"rebound", rebound}, {"trackers", trackers},     {"filtering", filtering},
        {"parity", parity},   {"paper", paperExperiment}, {"selftest", selftest}};
    const auto command = argc > 1 ? commands.find(argv[1]) : commands.end();
    const int code = command == commands.end() ? 2 : command->second(Arguments(argv + 2, argv + argc));
    if (code == 2)
        std::fputs(
            "usage: pdrender-bench picture SCENE.json [--samples N] [--device D] [--threads N] [--pfm FILE]\n"
            "       pdrender-bench frames SCENE.json [--frames N] [--threads N] [--colours FILE]\n"
            "       pdrender-bench compare PICTURE.pfm REFERENCE.pfm\n"
            "       pdrender-bench rebound [--size N] [--edits N] [--device D]\n"
            "       pdrender-bench trackers [SCENE.json ...] [--rays N] [--rounds N]\n"
            "       pdrender-bench filtering SCENE.json [--device D] [--samples N] [--points N] [--rounds N] [--json]\n"
            "       pdrender-bench paper [SCENE.json] [--device D] [--threads N] [--estimator unbiased|kroesMarch]\n"
            "                            [--clock wall|processor] [--largest WxH] [--seconds S] [--rounds N] [--out "
            "DIR]\n"
            "       pdrender-bench parity [--device D] [--quick] [NAMES]\n"
            "       pdrender-bench selftest [--device D] [--quick] [--seed N] [WORDS]\n",
            stderr);
    return code == kExplained ? 2 : code;
}
