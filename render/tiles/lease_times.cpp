#include "render/tiles/lease_times.h"

#include <algorithm>

namespace pdr {

void LeaseTimes::add(double work, double seconds) {
    count_ = kKept * count_ + 1;
    work_ = kKept * work_ + work;
    seconds_ = kKept * seconds_ + seconds;
    workSquared_ = kKept * workSquared_ + work * work;
    workSeconds_ = kKept * workSeconds_ + work * seconds;
}

/// Returns the slope of the fitted line. Leases of equal size determine no line: then all of the time is attributed to
/// samples.
double LeaseTimes::secondsPerWork() const {
    if (work_ <= 0)
        return 0;
    const double spread = count_ * workSquared_ - work_ * work_;
    const double mean = seconds_ / work_;
    if (spread <= 1e-6 * work_ * work_)
        return mean;
    return std::clamp((count_ * workSeconds_ - work_ * seconds_) / spread, 0.0, mean);
}

double LeaseTimes::secondsBefore() const {
    return count_ > 0 ? std::max(0.0, (seconds_ - secondsPerWork() * work_) / count_) : 0;
}

}  // namespace pdr
