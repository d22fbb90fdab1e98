#pragma once
/// The time axis of the accuracy strip: where a moment stands, and which labels have room beside each other.

#include <vector>

namespace pdr::ui {

/// Logarithmic from a second to an hour; earlier and later where a step asks for it. [0, 1].
class StripAxis {
  public:
    static constexpr double kMoment = 0.01, kSecond = 1, kHour = 3600;

    /// Of what must have its place, down to kMoment; not finite: the hour will do.
    explicit StripAxis(double first = kSecond, double last = kHour);

    /// Of `seconds` of rendering; what lies beyond either end stands there.
    double at(double seconds) const;

    /// The moment that stands there.
    double secondsAt(double place) const;

    double first() const { return first_; }
    double last() const { return last_; }

  private:
    double first_, last_;
};

/// A label that wants to stand with its middle at `middle`; a higher rank comes first.
struct StripLabel {
    double middle = 0, width = 0;
    int rank = 0;
    double left = 0;     ///< where it stands
    bool shown = false;  ///< it has room
};

/// Gives places in [0, width] to as many labels as have room with `gap` between them. They stay in their order.
void placeLabels(std::vector<StripLabel>& labels, double width, double gap);

}  // namespace pdr::ui
