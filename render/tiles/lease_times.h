#pragma once
/// Models the time of a lease as an overhead plus a time for each sample: a straight line fitted to the latest leases.
///   work   pixels times samples

namespace pdr {

class LeaseTimes {
  public:
    /// Adds a result that arrived `seconds` after its lease was given out or after the previous result, whichever is
    /// later.
    void add(double work, double seconds);

    double secondsPerWork() const;  ///< time of one sample of one pixel; 0: unknown
    double secondsBefore() const;   ///< overhead of a lease; 0: unknown or none

  private:
    static constexpr double kKept = 0.98;  ///< weight of the past, per result

    // Decayed sums for the least-squares line.
    double count_ = 0, work_ = 0, seconds_ = 0, workSquared_ = 0, workSeconds_ = 0;
};

}  // namespace pdr
