#pragma once
/// Class that turns Ctrl-C (SIGINT), SIGTERM and the end of the terminal's session (SIGHUP, unless it is ignored as
/// nohup does) into a stop request; the second signal ends the program at once. From its construction on, a broken pipe
/// is a write error instead of a signal.

#include <stop_token>
#include <thread>

namespace pdr::app {

class Interrupt {
  public:
    /// Blocks the signals. Must be constructed before any other thread starts, because threads inherit the blocked
    /// signals.
    Interrupt();
    ~Interrupt();

    std::stop_token token() const { return requested_.get_token(); }

  private:
    std::stop_source requested_;
    std::jthread watcher_;
};

}  // namespace pdr::app
