#pragma once
/// The self-test: every case, one after the other.

#include <string>
#include <vector>

#include "app/selftest/measure.h"

namespace pdr::selftest {

struct Plan {
    std::vector<Family> families;
    std::vector<std::string> words;  ///< only cases whose family and name hold all of them
    bool quick = false;              ///< fewer samples, which find larger biases only
    std::uint64_t seed = 1;
    double allowed = 0;  ///< |z| that chance may reach: allowedZ() of as many comparisons
};

/// How often each verdict was reached.
struct Tally {
    int agrees = 0, deviates = 0, tooBlunt = 0, faulty = 0;
    void count(Verdict verdict);
    int failed() const { return deviates + tooBlunt + faulty; }
    int all() const { return agrees + failed(); }
};

/// What is told while it runs.
class Observer {
  public:
    virtual ~Observer() = default;
    /// Before the first case of a family.
    virtual void begins(const Family& family) = 0;
    virtual void ends(const Case& reference, const Measurement& got, const Judgement& judgement,
                      const Sharpness& sharpness) = 0;
};

/// Adds to `tally`. Errors: the device fails; cancelled().
Result<void> run(const Plan& plan, Device& device, Observer& observer, const Cancelled& cancelled, Tally& tally);

}  // namespace pdr::selftest
