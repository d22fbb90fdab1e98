#include "ui/accuracy/strip_axis.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace pdr::ui {

StripAxis::StripAxis(double first, double last)
    : first_(std::clamp(first, kMoment, kSecond)), last_(std::isfinite(last) ? std::max(last, kHour) : kHour) {}

double StripAxis::at(double seconds) const {
    const double place = std::log(std::max(seconds, first_) / first_) / std::log(last_ / first_);
    return std::min(place, 1.0);
}

double StripAxis::secondsAt(double place) const {
    return first_ * std::pow(last_ / first_, place);
}

void placeLabels(std::vector<StripLabel>& labels, double width, double gap) {
    std::vector<std::size_t> order(labels.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return labels[a].rank > labels[b].rank; });
    for (const std::size_t index : order) {
        StripLabel& label = labels[index];
        label.left = std::clamp(label.middle - label.width / 2, 0.0, std::max(width - label.width, 0.0));
        label.shown = label.width <= width && std::none_of(labels.begin(), labels.end(), [&](const StripLabel& other) {
                          return other.shown && label.left < other.left + other.width + gap &&
                                 other.left < label.left + label.width + gap;
                      });
    }
}

}  // namespace pdr::ui
