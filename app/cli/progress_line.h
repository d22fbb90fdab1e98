#pragma once
/// Progress on stderr: one line that is redrawn on a terminal, plain lines from time to time elsewhere.

#include <chrono>
#include <stop_token>
#include <string>
#include <string_view>

#include "render/base/progress.h"
#include "render/session/batch_render.h"

namespace pdr::app {

class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();

    /// Shows a step with a known fraction, such as reading slices.
    void show(double fraction, std::string_view step);
    /// Shows the progress of rendering, with error and time left.
    void show(const BatchState& state);
    /// Returns what shows steps on this line, which must outlive it, and goes on until `stop` is requested.
    Progress until(std::stop_token stop = {});
    /// Ends the line, so that other output can follow.
    void finish();

  private:
    void draw(double fraction, const std::string& text);

    bool terminal_;
    bool open_ = false;
    std::string lastStep_;
    std::chrono::steady_clock::time_point lastPlain_;
};

/// Returns a duration as "0:07", "12:30" or "2:05:00".
std::string clockText(double seconds);
/// Returns "1 sample per pixel" or "64 samples per pixel".
std::string samplesText(std::uint64_t samplesPerPixel);

}  // namespace pdr::app
