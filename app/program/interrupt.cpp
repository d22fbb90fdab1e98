#include "app/program/interrupt.h"

#include <signal.h>
#include <time.h>

#include <csignal>

namespace pdr::app {
namespace {

sigset_t endingSignals() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    struct sigaction hangUp {};
    if (sigaction(SIGHUP, nullptr, &hangUp) == 0 && hangUp.sa_handler != SIG_IGN)  // nohup ignores it
        sigaddset(&set, SIGHUP);
    return set;
}

void watch(std::stop_token over, std::stop_source requested) {
    const sigset_t signals = endingSignals();
    const timespec patience{0, 50'000'000};
    while (!over.stop_requested()) {
        if (requested.stop_requested()) {
            nanosleep(&patience, nullptr);
        } else if (sigtimedwait(&signals, nullptr, &patience) > 0) {
            requested.request_stop();
            // The next signal reaches this thread and ends the program.
            pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
        }
    }
}

}  // namespace

Interrupt::Interrupt() {
    std::signal(SIGPIPE, SIG_IGN);  // if the reader of messages is gone, the program must still write its files
    const sigset_t signals = endingSignals();
    pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    watcher_ = std::jthread(watch, requested_);
}

Interrupt::~Interrupt() {
    watcher_.request_stop();
}

}  // namespace pdr::app
