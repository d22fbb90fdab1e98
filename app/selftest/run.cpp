#include "app/selftest/run.h"

#include <algorithm>

namespace pdr::selftest {

namespace {

bool isChosen(const Plan& plan, const Family& family, const Case& reference) {
    const std::string text = family.name + " " + reference.name;
    return std::ranges::all_of(plan.words,
                               [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

/// Returns the seed of a case, which does not depend on the cases that are run. Each case has its own, because an
/// unlucky choice of random numbers must not affect all of them alike.
std::uint64_t seedOf(const Plan& plan, std::uint64_t number) {
    return plan.seed * 1'000'000'007 + number * 1'000'003;
}

}  // namespace

void Tally::count(Verdict verdict) {
    agrees += verdict == Verdict::agrees;
    deviates += verdict == Verdict::deviates;
    tooBlunt += verdict == Verdict::tooBlunt;
    faulty += verdict == Verdict::faulty;
}

Result<void> run(const Plan& plan, Device& device, Observer& observer, const Cancelled& cancelled, Tally& tally) {
    std::uint64_t number = 0;
    for (const Family& family : plan.families) {
        bool begun = false;
        for (const Case& reference : family.cases) {
            const std::uint64_t seed = seedOf(plan, number++);
            if (!isChosen(plan, family, reference))
                continue;
            if (!begun)
                observer.begins(family);
            begun = true;
            const Sharpness& sharpness = plan.quick ? reference.quick : reference.full;
            const Result<Measurement> got = measure(device, reference, sharpness.samples, seed, cancelled);
            if (!got)
                return got.error().in(reference.name);
            const Judgement judgement = judge(reference, *got, sharpness, plan.allowed);
            observer.ends(reference, *got, judgement, sharpness);
            tally.count(judgement.verdict);
        }
    }
    return {};
}

}  // namespace pdr::selftest
