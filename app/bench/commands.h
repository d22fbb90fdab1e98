#pragma once
/// What pdrender-bench can measure. Each command takes the words after its name, prints one line of JSON or a short
/// table to standard output, and returns the exit code: 0, 1 for an error, 2 for wrong usage.

#include <string>
#include <vector>

namespace pdr::bench {

/// Wrong usage that the command has explained itself; the program ends with 2 without showing how it is used.
inline constexpr int kExplained = -2;

using Arguments = std::vector<std::string>;

/// picture SCENE.json [--samples N] [--device D] [--threads N] [--pfm FILE]: renders, and says how fast and how noisy.
int picture(const Arguments& arguments);

/// frames SCENE.json [--frames N] [--threads N] [--colours FILE]: renders one sample a pixel N times, and says how long
/// a frame takes: by the clock, and on all cores together. FILE gets the mean of all frames, linear, as a colour PFM.
int frames(const Arguments& arguments);

/// compare A.pfm REFERENCE.pfm: ratio of the means, and the root mean square difference over the reference's mean.
int compare(const Arguments& arguments);

/// rebound [--size N] [--edits N] [--device D] [--width N] [--height N]: time to bound an N x N x N head anew after a
/// transfer-function edit: on one core, or on a device with a memory of its own, there with sending what is needed; and
/// from the edit to its first picture, of width x height pixels.
int rebound(const Arguments& arguments);

/// sizes [--smallest N] [--largest N] [--samples N] [--rounds N]: what a sample costs in heads of ever more voxels,
/// twice as many an edge each time, of the same size in mm: processor time of one thread of the CPU.
int sizes(const Arguments& arguments);

/// trackers [SCENE.json ...] [--rays N] [--rounds N]: what ways to the first collision cost, side by side, for N x N
/// primary rays of each scene; without scenes, of a head phantom as bone, as skin over bone, and as soft tissue.
int trackers(const Arguments& arguments);

/// filtering SCENE.json [--device D] [--samples N] [--points N] [--rounds N] [--json]: what fast filtering of the
/// volume costs, in HU at N places and in display levels of a picture, and what time it saves. Without a GPU, D = cpu,
/// one is emulated on the CPU.
int filtering(const Arguments& arguments);

/// bits [SCENE.json ...] [--device D] [--threads N] [--samples N]: a line for the reference tiles of render nodes and for
/// the picture of each scene: the same on two machines where they make the same bits.
int bits(const Arguments& arguments);

/// paper [SCENE.json] [--device D] [--threads N] [--estimator unbiased|kroesMarch] [--clock wall|processor]
/// [--largest WxH] [--seconds S] [--rounds N] [--out DIR]: the experiment that this program began with: frames per
/// second, time of an iteration, time beside it, and efficiency, for six resolutions, Exposure Render's schedule and
/// ours with n = 1, 10 and 100. Each cell is measured for S seconds in N rounds. DIR gets paper.md, paper.csv and
/// paper.json. 1: it was broken off, too.
int paperExperiment(const Arguments& arguments);

/// parity [--device D] [--quick] [NAMES]: whether a device renders as the CPU does, sample by sample, and as itself
/// however the work is cut; without --quick also that pictures arrive whole and that memory returns. NAMES: of these
/// scenes only. 1: something fails.
int parity(const Arguments& arguments);

/// selftest [--device D] [--quick] [--seed N] [WORDS]: renders scenes that physics knows the answer to, and prints a
/// table. 1: the device deviates, or the test was broken off. WORDS: only cases whose name or family holds them.
int selftest(const Arguments& arguments);

/// scale [SCENE.json] [--device D] [--threads N] ...: what many nodes would make of this one's times, up to N of them, in
/// five ways to share frames out, by formulas and played event by event; beside runs of real nodes. PLOTS get SVG files.
int scaleOut(const Arguments& arguments);

/// prediction [SCENE.json ...] [--seeds N] [--threads N] [--width N] [--height N]: whether the tissue lies within what
/// is stated of it, and whether forecasts come true, from 64 and from 256 samples to three parts of the error; without
/// scenes, of six whose light is easy and hard to find.
int prediction(const Arguments& arguments);

/// accuracy-cost [SCENE.json] [--samples N] [--rounds N] [--iterations N] [--threads N] [--width N] [--height N]: what
/// a session takes beside the samples of its picture to say how right it is, always and with each part that is opened.
int accuracyCost(const Arguments& arguments);

/// warps SCENE.json [--samples N] [--width N] [--height N]: how full a GPU's warps are in the queues that it walks, by
/// warps that are played on the CPU: walks and steps for each sample, of lanes and of warps.
int warps(const Arguments& arguments);

/// smoothing SCENE.json [--samples N] [--reference N] [--rounds N] [--threads N] [--width N] [--height N] [--exposure
/// E]: how far the raw and the smoothed picture are from one of many samples, beside what is stated of both, for 1, 4,
/// 16,
/// ... N samples; and what both cost.
int smoothing(const Arguments& arguments);

}  // namespace pdr::bench
