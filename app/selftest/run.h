#pragma once
/// The self-test: runs all cases one after the other.

#include <string>
#include <vector>

#include "app/selftest/measure.h"

namespace pdr::selftest {

struct Plan {
    std::vector<Family> families;
    std::vector<std::string> words;  ///< only cases whose family and name contain all of these words are run
    bool quick = false;              ///< true: fewer samples, which detect only larger biases
    std::uint64_t seed = 1;
    double allowed = 0;  ///< |z| that chance may reach: allowedZ() for the number of comparisons
};

/// Number of cases with each verdict.
struct Tally {
    int agrees = 0, deviates = 0, tooBlunt = 0, faulty = 0;
    void count(Verdict verdict);
    int failed() const { return deviates + tooBlunt + faulty; }
    int all() const { return agrees + failed(); }
};

/// Callbacks of a run.
class Observer {
  public:
    virtual ~Observer() = default;
    /// Called before the first case of a family.
    virtual void begins(const Family& family) = 0;
    virtual void ends(const Case& reference, const Measurement& got, const Judgement& judgement,
                      const Sharpness& sharpness) = 0;
};

/// Runs the chosen cases and adds their verdicts to `tally`. Errors: the device fails; cancelled().
Result<void> run(const Plan& plan, Device& device, Observer& observer, const Cancelled& cancelled, Tally& tally);

}  // namespace pdr::selftest
