#include "tests/ptx/runtime/bad_address.h"

#include <execinfo.h>
#include <signal.h>
#include <unistd.h>

#include <cstring>

#include "tests/ptx/runtime/runtime.h"

namespace pdr::ptx {

namespace {

constexpr int kSegmentationFault = 139;  ///< what a shell says of a program that a bad address has ended

void say(const char* text) {
    (void)!write(STDERR_FILENO, text, std::strlen(text));
}

void onBadAddress(int, siginfo_t* what, void*) {
    const u64 address = reinterpret_cast<u64>(what->si_addr);
    Runtime& runtime = Runtime::get();
    if (runtime.memory.isDevice(address))
        say("ptx: the host follows an address of the device's\n");
    else if (runtime.pinned.beginOf(address) != 0)
        say("ptx: the host touches pinned memory of a copy that it has not waited for\n");
    else
        say("ptx: the host follows a bad address\n");
    void* frames[32];
    backtrace_symbols_fd(frames, backtrace(frames, 32), STDERR_FILENO);
    _exit(kSegmentationFault);
}

}  // namespace

void tellBadAddresses() {
    struct sigaction action {};
    action.sa_sigaction = onBadAddress;
    action.sa_flags = SA_SIGINFO;
    sigaction(SIGSEGV, &action, nullptr);
}

}  // namespace pdr::ptx
