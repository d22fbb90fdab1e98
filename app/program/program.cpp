#include "app/program/program.h"

#include <fcntl.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

namespace pdr::app {
namespace {

const char* programName = "";  // for the terminate handler, which takes no argument

void sayShortOf(const char* what) {
    std::fprintf(stderr, "%s: there is not enough %s. Close other programs, or take a smaller image or volume.\n",
                 programName, what);
}

void sayUnexpected(const char* what) {
    std::fprintf(stderr, "%s: an unexpected error ended the program: %s.\n", programName, what);
}

/// Returns whether a thread could not be started. oneTBB has no exception type of its own for that.
bool isThreadRefused(const std::exception& error) {
    const auto* system = dynamic_cast<const std::system_error*>(&error);
    return (system && system->code() == std::errc::resource_unavailable_try_again) ||
           std::strstr(error.what(), "pthread_create") != nullptr;
}

/// Prints a message about an unexpected exception. The likely reason is a lack of memory or threads.
void say(const std::exception_ptr& failure) {
    try {
        if (failure)
            std::rethrow_exception(failure);
        sayUnexpected("it has no name");
    } catch (const std::bad_alloc&) {
        sayShortOf("memory");
    } catch (const std::exception& error) {
        isThreadRefused(error) ? sayShortOf("memory for another thread") : sayUnexpected(error.what());
    } catch (...) {
        sayUnexpected("it has no name");
    }
}

/// Terminate handler for exceptions that no main() can catch: those of threads that a library started.
[[noreturn]] void endWithSentence() {
    say(std::current_exception());
    ::_exit(1);
}

/// Opens /dev/null in place of closed standard streams. Otherwise a file that is opened later could take the number of
/// standard output. The replacement has the wrong direction for its stream, so that the closed stream is still
/// detected.
void occupyClosedStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF)
            ::open("/dev/null",
                   stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // takes the lowest free number: this one
}

bool printedArrived() {
    errno = 0;
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
        return true;
    const char* reason = errno != 0 ? std::strerror(errno) : "a write failed";
    std::fprintf(stderr, "%s: what was printed could not be written (%s). Check where standard output goes.\n",
                 programName, reason);
    return false;
}

}  // namespace

void keepMemoryPrivate() {
    const rlimit none{0, 0};
    ::setrlimit(RLIMIT_CORE, &none);
    ::prctl(PR_SET_DUMPABLE, 0);  // the limit alone has no effect where a program collects core dumps
}

void keepNumbersPlain() {
    std::setlocale(LC_NUMERIC, "C");
}

void giveMemoryBack() {
#ifdef __GLIBC__
    // A fixed threshold; by default it grows up to 32 MB with the blocks that are freed.
    ::mallopt(M_MMAP_THRESHOLD, 1 << 20);
    // What each thread keeps: the buffers of a slice, which it would otherwise get anew, page by page, for every slice.
    ::mallopt(M_TRIM_THRESHOLD, 2 << 20);
#endif
}

int runProgram(const char* name, const std::function<int()>& work) {
    keepMemoryPrivate();
    programName = name;
    std::set_terminate(endWithSentence);
    std::signal(SIGXFSZ, SIG_IGN);  // the write then fails with EFBIG, which is reported
    occupyClosedStreams();
    int code = 1;
    try {
        code = work();
    } catch (...) {
        say(std::current_exception());
    }
    const bool arrived = printedArrived();
    return code == 0 && !arrived ? 1 : code;
}

}  // namespace pdr::app
