#pragma once
/// The last few of many measurements, and their median, in which a single disturbed measurement does not count.

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace pdr {

class Recent {
  public:
    /// Keeps the last `most` values, at least 1.
    explicit Recent(std::size_t most) : most_(most) {}

    void add(double value) {
        values_.push_back(value);
        if (values_.size() > most_)
            values_.pop_front();
    }
    /// Returns whether there are as many values as the median is taken of.
    bool full() const { return values_.size() == most_; }
    /// Returns the median, the upper one of an even number of values; `guess` without values.
    double median(double guess = 0) const {
        if (values_.empty())
            return guess;
        std::vector<double> sorted(values_.begin(), values_.end());
        const auto middle = sorted.begin() + std::ptrdiff_t(sorted.size() / 2);
        std::nth_element(sorted.begin(), middle, sorted.end());
        return *middle;
    }

  private:
    std::size_t most_;
    std::deque<double> values_;
};

}  // namespace pdr
