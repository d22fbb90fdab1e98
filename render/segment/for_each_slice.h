#pragma once
/// A loop over slices on all processors that can be stopped. For source files only: TBB and Qt's `emit` conflict.

#include <tbb/parallel_for.h>

#include <thread>

#include "render/segment/checkpoint.h"

namespace pdr::segment {

/// Calls body(i) for each i in [0, count), on all processors, with a checkpoint before each call that the calling
/// thread makes itself. If the checkpoint throws, the remaining calls are left out.
template <typename Body>
void forEachSlice(int count, const Checkpoint& checkpoint, const Body& body) {
    const std::thread::id caller = std::this_thread::get_id();
    tbb::parallel_for(0, count, [&](int i) {
        if (std::this_thread::get_id() == caller)
            checkpoint();
        body(i);
    });
}

}  // namespace pdr::segment
