#pragma once
/// How a program's PTX is run, and on what machine: from the environment, since the program itself must not know.

#include <string>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

/// When the work in a stream is done.
enum class Streams {
    atOnce,   ///< as soon as it is given
    late,     ///< when the host waits for it, and no more than that needs
    atRandom  ///< some of what may be done, whenever something is given
};
/// How warps of a launch take turns.
enum class Warps {
    inTurn,   ///< several in turn, some blocks of instructions each
    inOrder,  ///< one after the other, to its end
    atRandom  ///< as inTurn, the next one drawn; lanes of atomics in any order too
};
/// What fresh memory and registers hold.
enum class Fill { atRandom, ones, zeros };

struct Settings {
    Streams streams = Streams::atOnce;  ///< PDR_PTX_STREAMS: atOnce, late, atRandom
    Warps warps = Warps::inTurn;        ///< PDR_PTX_WARPS: inTurn, inOrder, atRandom
    Fill fill = Fill::atRandom;         ///< PDR_PTX_FILL: atRandom, ones, zeros
    bool byAddress = false;             ///< PDR_PTX_BY_ADDRESS: parted lanes go on at the lowest address first
    bool races = false;                 ///< PDR_PTX_RACES: threads, and streams, that meet at a byte are told
    bool unset = false;                 ///< PDR_PTX_UNSET: reads of what nobody has written are told
    u64 together = 64;                  ///< PDR_PTX_TOGETHER: warps of a launch that are under way at a time
    bool trace = false;                 ///< PDR_PTX_TRACE: every call of the runtime and every launch is told
    u32 seed = 1;                       ///< PDR_PTX_SEED
    std::string counts;                 ///< PDR_PTX_COUNTS: folder for counts, see runtime/counts.h; empty: none
    std::string fail;                   ///< PDR_PTX_FAIL: the call that fails, see runtime/failures.h
    u64 memoryBytes = u64(8) << 30;     ///< PDR_PTX_MEMORY_MB
    int processors = 132;               ///< PDR_PTX_PROCESSORS
    int devices = 1;                    ///< PDR_PTX_DEVICES
    int driver = 13000;                 ///< PDR_PTX_DRIVER: the CUDA version that it knows, 1000 * major + 10 * minor
    int capability = 90;                ///< PDR_PTX_CAPABILITY: 10 * major + minor
    int largestTexture = 16384;         ///< PDR_PTX_LARGEST_TEXTURE: voxels along an edge
};

/// Reads the environment. Ends the program with code 2 where a value is not one of those above.
Settings settingsFromEnvironment();

}  // namespace pdr::ptx
