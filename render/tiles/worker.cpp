#include "render/tiles/worker.h"

#include <algorithm>

namespace pdr {

void WorkerSpeed::add(double work, double seconds) {
    work_ = kKept * work_ + work;
    seconds_ = kKept * seconds_ + std::max(seconds, kShortestSeconds);
}

void Worker::updateState() {
    if (isQuarantined())
        return;
    status.state = isDraining   ? WorkerState::draining
                   : isSuspect  ? WorkerState::suspect
                   : isPaused   ? WorkerState::paused
                   : scene == 0 ? WorkerState::waiting
                                : WorkerState::ready;
}

}  // namespace pdr
