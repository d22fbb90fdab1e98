#pragma once
/// Turns Ctrl-C (SIGINT), SIGTERM and the end of the terminal's session (SIGHUP, unless it is ignored as nohup does)
/// into a stop request; the second one ends the program at once. While it is there, and after, broken pipes are errors
/// of writing.

#include <stop_token>
#include <thread>

namespace pdr::app {

class Interrupt {
  public:
    /// Make it before any other thread starts: threads inherit that the signals are held back from them.
    Interrupt();
    ~Interrupt();

    std::stop_token token() const { return requested_.get_token(); }

  private:
    std::stop_source requested_;
    std::jthread watcher_;
};

}  // namespace pdr::app
