#pragma once
/// Says on stderr how far it is: one line that is drawn anew on a terminal, plain lines now and then elsewhere.

#include <chrono>
#include <string>
#include <string_view>

#include "render/session/batch_render.h"

namespace pdr::app {

class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();

    /// A step with a known fraction, such as reading slices.
    void show(double fraction, std::string_view step);
    /// The rendering, with error and time left.
    void show(const BatchState& state);
    /// Ends the line, so that something else can be written.
    void finish();

  private:
    void draw(double fraction, const std::string& text);

    bool terminal_;
    bool open_ = false;
    std::string lastStep_;
    std::chrono::steady_clock::time_point lastPlain_;
};

/// "0:07", "12:30", "2:05:00"
std::string clockText(double seconds);
/// "1 sample per pixel", "64 samples per pixel"
std::string samplesText(std::uint64_t samplesPerPixel);

}  // namespace pdr::app
