#pragma once
/// Commands of pdrender-bench. Each takes the words after its name, prints one line of JSON or a short table to
/// standard output, and returns the exit code: 0, 1 for an error, 2 for wrong usage.

#include <string>
#include <vector>

namespace pdr::bench {

/// Return value for wrong usage that the command has explained itself. The program exits with 2 and does not show the
/// usage.
inline constexpr int kExplained = -2;

using Arguments = std::vector<std::string>;

/// image SCENE.json [--samples N] [--device D] [--threads N] [--pfm FILE]: renders an image and prints how fast and
/// how noisy it is.
int image(const Arguments& arguments);

/// frames SCENE.json [--frames N] [--threads N] [--colours FILE]: renders one sample per pixel N times and prints the
/// time of a frame, by the clock and on all cores together. FILE gets the linear mean of all frames as a colour PFM.
int frames(const Arguments& arguments);

/// compare A.pfm REFERENCE.pfm: prints the ratio of the means, and the root mean square difference over the reference's
/// mean.
int compare(const Arguments& arguments);

/// rebound [--size N] [--edits N] [--device D] [--width N] [--height N]: measures the time to rebuild the majorants of
/// an N x N x N head after an edit of the transfer function, on one core or on a device with its own memory (there
/// including the transfer), and the time from the edit to its first image of width x height pixels.
int rebound(const Arguments& arguments);

/// sizes [--smallest N] [--largest N] [--samples N] [--rounds N]: measures the cost of a sample in heads of the same
/// size in mm with more and more voxels, twice as many along an edge each time: processor time of one CPU thread.
int sizes(const Arguments& arguments);

/// parts [--size N] [--samples N] [--rounds N] [--json]: measures the cost of a sample in a head that is divided among
/// several parts with curves of their own, against one without parts: processor time of one CPU thread, and memory.
int parts(const Arguments& arguments);

/// ct-noise [SCENE.json] [--slices N] [--rounds N]: measures the time to denoise the scan of a scene for its images, or
/// a head of 512 x 512 x N voxels, and the noise that its tissue has before and after.
int ctNoise(const Arguments& arguments);

/// trackers [SCENE.json ...] [--rays N] [--rounds N]: compares the cost of several ways to find the first collision,
/// for N x N primary rays of each scene; without scenes, of a head phantom as bone, as skin over bone, and as soft
/// tissue.
int trackers(const Arguments& arguments);

/// filtering SCENE.json [--device D] [--samples N] [--points N] [--rounds N] [--json]: measures what fast filtering of
/// the volume costs, in HU at N places and in display levels of an image, and what time it saves. With D = cpu, a GPU
/// is emulated on the CPU.
int filtering(const Arguments& arguments);

/// bits [SCENE.json ...] [--device D] [--threads N] [--samples N]: prints a line for the reference tiles of render
/// nodes and one for the image of each scene. Two machines that make the same bits print the same lines.
int bits(const Arguments& arguments);

/// paper [SCENE.json] [--device D] [--threads N] [--estimator unbiased|kroesMarch] [--clock wall|processor] [--largest
/// WxH] [--seconds S] [--rounds N] [--out DIR]: repeats the experiment that this program began with. Measures frames
/// per second, the time of an iteration, the time of a frame beside its iterations, and efficiency, for six
/// resolutions, Exposure Render's schedule and ours with n = 1, 10 and 100. Each cell is measured for S seconds in N
/// rounds. DIR gets paper.md, paper.csv and paper.json. Also returns 1 if it was interrupted.
int paperExperiment(const Arguments& arguments);

/// parity [--device D] [--quick] [NAMES]: checks whether a device renders the same as the CPU, sample by sample, and
/// gives the same image however the work is divided; without --quick also that images arrive whole and that memory is
/// returned. NAMES: only these scenes. Returns 1 if a check fails.
int parity(const Arguments& arguments);

/// selftest [--device D] [--quick] [--seed N] [WORDS]: renders scenes whose result is known from physics and prints a
/// table. WORDS: only cases whose name or family contains each of them. Returns 1 if the device deviates or the test
/// was interrupted.
int selftest(const Arguments& arguments);

/// scale [SCENE.json] [--device D] [--threads N] ...: predicts from the times of this node how up to N nodes perform,
/// in five ways to divide frames, by formulas and by an event simulation, and compares with runs of real nodes. PLOTS
/// gets SVG files.
int scaleOut(const Arguments& arguments);

/// prediction [SCENE.json ...] [--seeds N] [--threads N] [--width N] [--height N]: measures whether the tissue lies
/// within the stated error and whether forecasts come true, from 64 and from 256 samples to three fractions of the
/// error; without scenes, of six whose light is easy or hard to find.
int prediction(const Arguments& arguments);

/// accuracy-cost [SCENE.json] [--samples N] [--rounds N] [--iterations N] [--threads N] [--width N] [--height N]:
/// measures the processor time that a session takes beside the samples of its image to state its accuracy, always and
/// with each part of the window that is opened.
int accuracyCost(const Arguments& arguments);

/// warps SCENE.json [--samples N] [--width N] [--height N]: measures how many lanes of a GPU's warps take part in each
/// step of the queues that they walk, with warps that are simulated on the CPU: walks and steps per sample, of lanes
/// and of warps. Within a step lanes part: tools/measure/gpu_instructions.py counts those that are busy in an
/// instruction.
int warps(const Arguments& arguments);

/// smoothing SCENE.json [--samples N] [--reference N] [--rounds N] [--threads N] [--width N] [--height N] [--exposure
/// E]: measures the error of the raw and of the denoised image against an image of many samples, beside the stated
/// errors of both, for 1, 4, 16, ... N samples, and the cost of both.
int smoothing(const Arguments& arguments);

}  // namespace pdr::bench
