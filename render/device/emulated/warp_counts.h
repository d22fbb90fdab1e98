#pragma once
/// Counts of how the warps of a queue spend their time: how many of their 32 walks go on in each step.

#include <cstdint>

namespace pdr {

/// Counts of one warp since its lanes last met.
struct WalkCounts {
    std::uint64_t started = 0, stepped = 0;
};

struct WarpCounts {
    std::uint64_t starts = 0, started = 0;  ///< times that a warp started walks, and the walks that it started
    std::uint64_t steps = 0, stepped = 0;   ///< steps of warps, and steps of walks in them

    void add(const WalkCounts& since) {
        starts += since.started > 0;
        started += since.started;
        steps += since.stepped > 0;
        stepped += since.stepped;
    }
    void add(const WarpCounts& other) {
        starts += other.starts;
        started += other.started;
        steps += other.steps;
        stepped += other.stepped;
    }
};

/// A program for a queue (gpu.h) with counted calls.
template <class Program>
struct CountedWalks {
    using Walk = typename Program::Walk;
    const Program& program;
    WalkCounts& counts;

    bool start(std::int64_t index, Walk& walk) const {
        ++counts.started;
        return program.start(index, walk);
    }
    bool step(Walk& walk) const {
        ++counts.stepped;
        return program.step(walk);
    }
};

}  // namespace pdr
