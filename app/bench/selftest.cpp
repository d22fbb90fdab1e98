#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/bench/commands.h"
#include "app/bench/held_signals.h"
#include "app/bench/options.h"
#include "app/bench/selftest_measure.h"
#include "app/bench/selftest_table.h"
#include "render/accuracy/significance.h"
#include "render/device/device_list.h"

namespace pdr::bench {

namespace {

int fail(const Error& error) {
    std::fprintf(stderr, "pdrender-bench: %s\n", error.text().c_str());
    return 1;
}

bool chosen(const Options& options, const Family& family, const Case& reference) {
    const std::string text = family.name + " " + reference.name;
    return std::ranges::all_of(options.files,
                               [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

struct Plan {
    const Options& options;
    TableHead head;
    Device& device;
    const Cancelled& cancelled;
    const std::vector<Family>& families;
};

/// Every case has random numbers of its own, whichever others are run: chance must not strike them all alike.
std::uint64_t seedOf(const Plan& plan, const Case& reference) {
    std::uint64_t number = 0;
    for (const Family& family : plan.families)
        for (const Case& one : family.cases) {
            if (&one == &reference)
                return plan.head.seed * 1'000'000'007 + number * 1'000'003;
            ++number;
        }
    return plan.head.seed;
}

/// Adds to `tally`; an Error where the device fails or the user breaks off.
Result<void> run(const Plan& plan, const Family& family, Tally& tally) {
    bool titled = false;
    for (const Case& reference : family.cases) {
        if (!chosen(plan.options, family, reference))
            continue;
        if (!titled)
            printFamily(family);
        titled = true;
        const Sharpness& sharpness = plan.head.quick ? reference.quick : reference.full;
        const Result<Measurement> got =
            measure(plan.device, reference, sharpness.samples, seedOf(plan, reference), plan.cancelled);
        if (!got)
            return Error{got.error().text(), reference.name, ""};
        const Judgement judgement = judge(reference, *got, sharpness, plan.head.allowed);
        printRow(reference, *got, judgement, sharpness);
        tally.count(judgement.verdict);
    }
    return {};
}

int runAll(const Plan& plan) {
    const auto start = std::chrono::steady_clock::now();
    Tally tally;
    Result<void> ran;
    printHead(plan.head);
    for (const Family& family : plan.families)
        if (ran = run(plan, family, tally); !ran)
            break;
    const bool brokenOff = plan.cancelled();
    if (!ran && !brokenOff)
        return fail(ran.error());
    if (tally.all() == 0 && !brokenOff)
        return fail({"no case is called so", plan.options.files.front(), ""});
    printEnd(tally, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), brokenOff);
    return brokenOff || tally.failed() > 0 ? 1 : 0;
}

}  // namespace

int selftest(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--device", "--seed"}, {"--quick"});
    const auto seed = options ? options->number("--seed", 1, 0) : std::nullopt;
    if (!seed)
        return 2;
    const auto named = options->named.find("--device");
    HeldSignals signals;
    const Result<std::unique_ptr<Device>> device = openDevice(named == options->named.end() ? "cpu" : named->second);
    if (!device) {
        fail(device.error());
        return kExplained;
    }
    const Result<std::vector<Family>> families = shippedFamilies();
    if (!families)
        return fail(families.error());
    int comparisons = 0;
    for (const Family& family : *families)
        comparisons += int(family.cases.size());
    const DeviceInfo info = (*device)->info();
    const Cancelled cancelled = [&] { return signals.came(); };
    const TableHead head{info.name + ", " + info.details, options->named.contains("--quick"), comparisons,
                         allowedZ(comparisons), std::uint64_t(*seed)};
    return runAll({*options, head, **device, cancelled, *families});
}

}  // namespace pdr::bench
