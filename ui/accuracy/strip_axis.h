#pragma once
/// The time axis of the accuracy strip: the place of each moment, and which labels fit beside each other.

#include <vector>

namespace pdr::ui {

/// A logarithmic time axis from a second to an hour, or from earlier and to later where a step needs it. Places are in
/// [0, 1].
class StripAxis {
  public:
    static constexpr double kMoment = 0.01, kSecond = 1, kHour = 3600;

    /// Creates an axis that includes `first` and `last` [s], but no time before kMoment. `last` not finite: the axis
    /// ends at an hour.
    explicit StripAxis(double first = kSecond, double last = kHour);

    /// Returns the place of `seconds` of rendering. Times beyond either end lie on it.
    double at(double seconds) const;

    /// Returns the time at `place` [s].
    double secondsAt(double place) const;

    double first() const { return first_; }
    double last() const { return last_; }

  private:
    double first_, last_;
};

/// A label, preferably centred at `middle`. Labels of higher rank are placed first.
struct StripLabel {
    double middle = 0, width = 0;
    int rank = 0;
    double left = 0;     ///< left edge, set by placeLabels()
    bool shown = false;  ///< there is room for it, set by placeLabels()
};

/// Places as many labels in [0, width] as fit with `gap` between them. Their order does not change.
void placeLabels(std::vector<StripLabel>& labels, double width, double gap);

}  // namespace pdr::ui
