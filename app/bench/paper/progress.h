#pragma once
/// Progress on standard error: what is measured and how long it will take. One line that is redrawn on a terminal,
/// plain lines from time to time elsewhere.

#include <chrono>
#include <string>

namespace pdr::bench::paper {

class Progress {
  public:
    Progress();
    ~Progress();

    void show(const std::string& what, double secondsLeft);

  private:
    bool terminal_;
    bool open_ = false;
    std::chrono::steady_clock::time_point last_;
};

}  // namespace pdr::bench::paper
