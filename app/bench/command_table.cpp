#include "app/bench/command_table.h"

namespace pdr::bench {

namespace {

constexpr Command kCommands[] = {
    {"picture", image, "SCENE.json [--samples N] [--device D] [--threads N] [--pfm FILE]",
     "Renders an image and says how fast and how noisy it is, as one line of JSON.\n",
     "  --samples N   samples per pixel, from 1; default 64\n"
     "  --device D    cpu (default), cuda, cuda:1, auto, or emulated: a GPU's kernels, emulated on the CPU\n"
     "  --threads N   threads of the CPU; default 0: one per core\n"
     "  --pfm FILE    write the image's luminance, linear, as a PFM\n"},
    {"frames", frames, "SCENE.json [--frames N] [--threads N] [--colours FILE]",
     "Renders one sample per pixel N times on the CPU and says how long a frame takes, by the clock and on all cores\n"
     "together, as one line of JSON.\n",
     "  --frames N      from 1; default 15\n"
     "  --threads N     default 0: one per core\n"
     "  --colours FILE  write the mean of all frames, linear, as a colour PFM\n"},
    {"compare", compare, "PICTURE.pfm REFERENCE.pfm",
     "Prints the ratio of the means, and the root mean square difference over the reference's mean, as JSON.\n", ""},
    {"rebound", rebound, "[--size N] [--edits N] [--device D] [--width N] [--height N]",
     "Times how long N x N x N voxels take to be bounded anew after an edit of the transfer function: on one core, or "
     "on\n"
     "a device with a memory of its own; and how long it is from the edit to its first image.\n",
     "  --size N      voxels an edge, from 2; default 256\n"
     "  --edits N     from 1; default 21\n"
     "  --device D    cpu (default), cuda, cuda:1, auto or emulated\n"
     "  --width N     pixels of the image, from 1; default 1920\n"
     "  --height N    from 1; default 1080\n"},
    {"sizes", sizes, "[--smallest N] [--largest N] [--samples N] [--rounds N]",
     "Says what a sample costs in heads of ever more voxels, twice as many an edge each time: always the same head in\n"
     "mm, by the processor time of one thread. All are held in memory and take turns.\n",
     "  --smallest N  voxels an edge, from 1; default 128\n"
     "  --largest N   voxels an edge; default 512; 1024 takes 3 GB and some minutes\n"
     "  --samples N   per pixel and round, from 1; default 16\n"
     "  --rounds N    of which the median counts, from 1; default 5\n"},
    {"parts", parts, "[--size N] [--samples N] [--rounds N] [--json]",
     "Says what a sample of a head costs whose voxels are divided among 1 to 255 parts with curves of their own,\n"
     "against one without parts, by the processor time of one thread; and what memory the parts take.\n",
     "  --size N      voxels an edge, from 1; default 256\n"
     "  --samples N   per pixel and round, from 1; default 4\n"
     "  --rounds N    of which the median counts, from 1; default 9\n"
     "  --json        print a line of JSON for each number of parts instead of a table\n"},
    {"ct-noise", ctNoise, "[SCENE.json] [--slices N] [--rounds N]",
     "Says how long it takes to denoise the scan of a scene for its images, for each 100 slices, and what noise its\n"
     "tissue has before and after; without a scene, a head of 512 x 512 voxels a slice.\n",
     "  --slices N    of the head, from 1; default 100\n"
     "  --rounds N    of which the median counts, from 1; default 5\n"},
    {"trackers", trackers, "[SCENE.json ...] [--rays N] [--rounds N]",
     "Compares what ways to the first collision cost, for the primary rays of each scene; without scenes, of a head.\n",
     "  --rays N      N x N primary rays, from 1; default 96\n"
     "  --rounds N    of which the median counts, from 1; default 9\n"},
    {"filtering", filtering, "SCENE.json [--device D] [--samples N] [--points N] [--rounds N] [--json]",
     "Says what fast filtering of the volume costs, in HU and in display levels, and what time it saves.\n",
     "  --device D    cuda, cuda:1 or auto; default cpu: a GPU is emulated on the CPU, and times say little\n"
     "  --samples N   samples per pixel, from 2; default 64\n"
     "  --points N    places at which HU are compared; default 1000000\n"
     "  --rounds N    of which the median counts, from 1; default 3\n"
     "  --json        print one line of JSON instead of a table\n"},
    {"bits", bits, "[SCENE.json ...] [--device D] [--threads N] [--samples N]",
     "Prints a number for the reference tiles of render nodes and for the image of each scene. Two machines that\n"
     "print the same may fill one image together.\n",
     "  --device D    cpu (default), cuda, cuda:1, auto or emulated\n"
     "  --threads N   threads of the CPU; default 0: one per core\n"
     "  --samples N   per pixel, from 1; default 70\n"},
    {"paper", paperExperiment,
     "[SCENE.json] [--device D] [--threads N] [--estimator E] [--clock C] [--largest WxH]\n"
     "                            [--seconds S] [--rounds N] [--out DIR]",
     "Repeats the experiment that this program began with: frames per second, the time of an iteration, the time "
     "beside\n"
     "it, and efficiency, for six resolutions, Exposure Render's order of work and ours with n = 1, 10 and 100.\n",
     "  --device D       cpu (default), cuda, cuda:1, auto or emulated\n"
     "  --threads N      threads of the CPU; default 0: one per core\n"
     "  --estimator E    unbiased or kroesMarch; default: the scene's own\n"
     "  --clock C        wall (default), or processor: for a shared machine, on the CPU\n"
     "  --largest WxH    leave out what is larger; default 1920x1080\n"
     "  --seconds S      for which each cell is measured, in all rounds; default 3\n"
     "  --rounds N       in which it is measured, from 1; default 5\n"
     "  --out DIR        write paper.md, paper.csv and paper.json there\n"},
    {"parity", parity, "[--device D] [--quick] [NAMES]",
     "Says whether a device renders as the CPU does, sample by sample, and as itself however the work is cut. NAMES: "
     "of\n"
     "these scenes only. Exit code 1: something fails.\n",
     "  --device D    cuda (default), cuda:1, auto or emulated\n"
     "  --quick       leave out that images arrive whole and that memory returns\n"},
    {"selftest", selftest, "[--device D] [--quick] [--seed N] [WORDS]",
     "Renders scenes that physics knows the answer to and says which agree, how sure that is, and which bias it would\n"
     "have found. WORDS: only cases whose name or family holds them. Exit code 1: the device deviates, or Ctrl-C.\n",
     "  --device D    cpu (default), cuda, cuda:1, auto or emulated\n"
     "  --quick       20 s instead of about 5 minutes on two cores; finds larger biases only\n"
     "  --seed N      of the random numbers; default 1\n"},
    {"prediction", prediction, "[SCENE.json ...] [--seeds N] [--threads N] [--width N] [--height N]",
     "Says how much of the tissue lies within the error stated for 95 % of it, and whether forecasts come true: "
     "samples\n"
     "to three parts of the error, foretold over needed, and how often the 95 % interval holds; without scenes, of a\n"
     "head with easy and hard light. Takes minutes.\n",
     "  --seeds N     images of each, from 2; default 40\n"
     "  --threads N   of the CPU; default 0: one per core\n"
     "  --width N     pixels of an image, from 8; default 28\n"
     "  --height N    default 22\n"},
    {"accuracy-cost", accuracyCost,
     "[SCENE.json] [--samples N] [--rounds N] [--iterations N] [--threads N]\n"
     "                            [--width N] [--height N]",
     "Says what it costs to say how right an image is: the processor time that a session takes beside the samples of\n"
     "its image, in parts of theirs, always and with each part of the window that is opened; without a scene, of a\n"
     "head of bone. Takes minutes.\n",
     "  --samples N     the most, from 64; default 256\n"
     "  --rounds N      of which the median counts, from 1; default 3\n"
     "  --iterations N  of a displayed frame, from 1; default 1\n"
     "  --threads N     of the CPU; default 0: one per core\n"
     "  --width N       pixels of the image, from 64; default 480\n"
     "  --height N      default 384\n"},
    {"scale", scaleOut,
     "[SCENE.json] [--device D] [--threads N] [--seconds S] [--width N] [--height N]\n"
     "                            [--samples N] [--per-launch N] [--nodes N] [--tiles N] [--launch S]\n"
     "                            [--sample S] [--pixel S] [--serial S] [--latency S] [--bandwidth B] [--message S]\n"
     "                            [--pixel-bytes B] [--order-bytes B] [--sum-bytes B] [--checked P]\n"
     "                            [--relays N] [--scan-bytes B] [--json] [--plots DIR]\n"
     "                            [--measured FILE]",
     "Says what many render nodes would make of this machine's times: frames a second, latency, efficiency and bytes "
     "of\n"
     "five ways to share frames out, by formulas and, where it is a star, played event by event; what ends the gain "
     "of\n"
     "more nodes; and when all of them have the scan. Measures a node first.\n",
     "  --device D       cpu (default), cuda, cuda:1, auto or emulated\n"
     "  --threads N      threads of the CPU; default 0: one per core\n"
     "  --seconds S      for which each of 15 kinds of frame is measured; default 0.1\n"
     "  --width N        pixels of the image, from 16; default 1920\n"
     "  --height N       default 1080\n"
     "  --samples N      of each pixel of a frame, from 1; default 256\n"
     "  --per-launch N   of them in one launch, from 1; default 64\n"
     "  --nodes N        the most, from 1; default 100000\n"
     "  --tiles N        of a node and frame, from 1, while no tile has fewer than 256 pixels; default 8\n"
     "  --launch S       T0 in seconds, in place of what is measured; with the next three nothing is measured\n"
     "  --sample S       alpha, of a sample of a pixel\n"
     "  --pixel S        beta, of a pixel of a frame\n"
     "  --serial S       Tc, of a frame\n"
     "  --latency S      of a message, one way; default 0.0001\n"
     "  --bandwidth B    bytes a second of a link; default 125000000\n"
     "  --message S      that a message costs who shows the image; default 0.00002\n"
     "  --pixel-bytes B  of a finished pixel from a node; default 25\n"
     "  --order-bytes B  of requests, per finished pixel; default 0.5\n"
     "  --sum-bytes B    of a pixel's 64 samples, to which others add; default 18\n"
     "  --checked P      part of the samples that a second node takes, to check the first; default 0.02\n"
     "  --relays N       between coordinator and nodes; default 0\n"
     "  --scan-bytes B   of a scan on its way to a node; default 72000000\n"
     "  --json           print JSON instead of tables\n"
     "  --plots DIR      write rate.svg, latency.svg, efficiency.svg and bytes.svg there\n"
     "  --measured FILE  compare with runs of real nodes: JSON, see the manual's nodes-scaling.md\n"},
    {"warps", warps, "SCENE.json [--samples N] [--width N] [--height N]",
     "Says how full a GPU's queues are, without a GPU: walks and steps for each sample, of lanes and of warps, and "
     "how\n"
     "many of a warp's 32 lanes take part in a step. Within a step they part, so far fewer are busy in each "
     "instruction:\n"
     "tools/measure/gpu_instructions.py.\n",
     "  --samples N   samples per pixel, from 1; default 1\n"
     "  --width N     pixels of the image, from 1; default 480\n"
     "  --height N    from 1; default 270\n"},
    {"smoothing", smoothing,
     "SCENE.json [--samples N] [--reference N] [--rounds N] [--threads N]\n"
     "                            [--width N] [--height N] [--exposure E]",
     "Says how far the raw and the denoised image are from one of many samples, beside what is stated of both, and "
     "what\n"
     "both cost, for 1, 4, 16, ... samples per pixel.\n",
     "  --samples N    the most, from 1; default 64\n"
     "  --reference N  samples of the image to compare with, from 2; default 1024\n"
     "  --rounds N     of which the median time counts, from 1; default 5\n"
     "  --threads N    of the CPU; default 0: one per core\n"
     "  --width N      pixels of the image; default 960\n"
     "  --height N     default 640\n"
     "  --exposure E   radiance that is shown as 1 - 1/e; default 1\n"},
};

std::string usageOf(const Command& command) {
    return std::string("pdrender-bench ") + command.name + " " + command.usage + "\n";
}

}  // namespace

std::span<const Command> commandTable() {
    return kCommands;
}

std::string helpOf(const Command& command) {
    const std::string options = command.options;
    return "Usage: " + usageOf(command) + command.explanation + (options.empty() ? "" : "\nOptions:\n" + options);
}

std::string helpOfAll() {
    std::string text =
        "pdrender-bench: measures the renderer alone, on scene files with raw volumes. Not for diagnostic use.\n\n";
    for (const Command& command : kCommands)
        text += "  " + usageOf(command);
    return text +
           "  pdrender-bench help COMMAND    explain a command and its options; the same as COMMAND --help\n"
           "  pdrender-bench --version       say which version this is\n"
           "\n"
           "Exit codes: 0 done, 1 error, 2 wrong usage.\n";
}

}  // namespace pdr::bench
