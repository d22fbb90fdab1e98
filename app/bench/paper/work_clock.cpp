#include "app/bench/paper/work_clock.h"

#include <chrono>

#include "app/bench/paper/device_load.h"
#include "render/base/processor_time.h"

namespace pdr::bench::paper {

WorkClock clockOf(TimeOf time, int threads) {
    if (time == TimeOf::processor)
        return [count = threadCount(threads)] { return processorSeconds() / count; };
    return [] { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); };
}

}  // namespace pdr::bench::paper
