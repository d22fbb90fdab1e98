#pragma once
/// What leases take: something before the first sample, and so much for each; a straight line through the last ones.
///   work   pixels times samples

namespace pdr {

class LeaseTimes {
  public:
    /// A result came so many seconds after the lease was given out, or after the result before it.
    void add(double work, double seconds);

    double secondsPerWork() const;  ///< 0: nothing is known
    double secondsBefore() const;   ///< likewise; >= 0

  private:
    static constexpr double kKept = 0.98;  ///< of what was known, with each result

    // Decayed sums for the line of least squares.
    double count_ = 0, work_ = 0, seconds_ = 0, workSquared_ = 0, workSeconds_ = 0;
};

}  // namespace pdr
