#include "render/base/background_thread.h"

#include <sys/resource.h>
#include <unistd.h>

namespace pdr {

namespace {

constexpr int kSteps = 5;

thread_local bool inBackground = false;

}  // namespace

void workInBackground() {
    if (inBackground)
        return;
    inBackground = true;
    // Linux keeps a priority for each thread, under the thread's number; a new thread has that of its parent.
    setpriority(PRIO_PROCESS, id_t(gettid()), getpriority(PRIO_PROCESS, id_t(getpid())) + kSteps);
}

bool worksInBackground() {
    return inBackground;
}

}  // namespace pdr
