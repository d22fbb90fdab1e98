#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "app/bench/commands.h"
#include "app/bench/held_signals.h"
#include "app/bench/options.h"
#include "app/bench/selftest/table.h"
#include "app/selftest/run.h"
#include "render/base/significance.h"
#include "render/device/device_list.h"

namespace pdr::bench {

namespace {

int fail(const Error& error) {
    std::fprintf(stderr, "pdrender-bench: %s\n", error.text().c_str());
    return 1;
}

/// Prints the report row by row.
class PrintedTable : public selftest::Observer {
  public:
    void begins(const selftest::Family& family) override { printFamily(family); }
    void ends(const selftest::Case& reference, const selftest::Measurement& got, const selftest::Judgement& judgement,
              const selftest::Sharpness& sharpness) override {
        printRow(reference, got, judgement, sharpness);
    }
};

int runAll(const selftest::Plan& plan, Device& device, const selftest::TableHead& head) {
    HeldSignals signals;
    const auto start = std::chrono::steady_clock::now();
    PrintedTable table;
    selftest::Tally tally;
    printHead(head);
    const Result<void> ran = run(
        plan, device, table, [&] { return signals.came(); }, tally);
    const bool brokenOff = signals.came();
    if (!ran && !brokenOff)
        return fail(ran.error());
    if (tally.all() == 0 && !brokenOff)
        return fail({"no case is called so", plan.words.front(), ""});
    printEnd(tally, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), brokenOff);
    return brokenOff || tally.failed() > 0 ? 1 : 0;
}

}  // namespace

int selftest(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--device", "--seed"}, {"--quick"});
    const auto seed = options ? options->number("--seed", 1, 0) : std::nullopt;
    if (!seed)
        return 2;
    const Result<std::unique_ptr<Device>> device = openDevice(options->word("--device", "cpu"));
    if (!device) {
        fail(device.error());
        return kExplained;
    }
    Result<std::vector<selftest::Family>> families = selftest::shippedFamilies();
    if (!families)
        return fail(families.error());
    int comparisons = 0;
    for (const selftest::Family& family : *families)
        comparisons += int(family.cases.size());
    const selftest::Plan plan{.families = *std::move(families),
                              .words = options->files,
                              .quick = options->named.contains("--quick"),
                              .seed = std::uint64_t(*seed),
                              .allowed = allowedZ(comparisons)};
    const DeviceInfo info = (*device)->info();
    return runAll(plan, **device, {info.name + ", " + info.details, plan.quick, comparisons, plan.allowed, plan.seed});
}

}  // namespace pdr::bench
