#include "app/bench/selftest/table.h"

#include <cstdio>
#include <sstream>

namespace pdr::selftest {

namespace {

const char* sentence(Verdict verdict) {
    switch (verdict) {
        case Verdict::agrees:
            return "agrees";
        case Verdict::deviates:
            return "DEVIATES";
        case Verdict::tooBlunt:
            return "TOO NOISY";
        case Verdict::faulty:
            break;
    }
    return "FAULTY";
}

/// Prints `text` in lines of at most 116 characters, with two spaces before each.
void printWrapped(const std::string& text) {
    std::istringstream words(text);
    std::string line, word;
    while (words >> word) {
        if (!line.empty() && line.size() + word.size() > 115) {
            std::printf("  %s\n", line.c_str());
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    std::printf("  %s\n", line.c_str());
}

}  // namespace

void printHead(const TableHead& head) {
    std::printf(
        "PD-Render self-test: %s; %s run, seed %llu\n"
        "Scenes that physics knows the answer to are rendered and compared with it.\n"
        "  z         deviation from the expected value in standard errors; up to %.2f is chance: of 10,000 runs of a\n"
        "            faultless renderer, with %d comparisons each, one deviates\n"
        "  detects   relative bias that this run finds nine times out of ten\n",
        head.device.c_str(), head.quick ? "quick" : "full", static_cast<unsigned long long>(head.seed), head.allowed,
        head.comparisons);
    std::fflush(stdout);
}

void printFamily(const Family& family) {
    std::printf("\n%s\n", family.name.c_str());
    printWrapped(family.note);
    std::printf("  %-48s %12s %12s %10s %6s %10s  %-10s %s\n", "case", "expected", "got", "std error", "z", "detects",
                "verdict", "source");
    std::fflush(stdout);
}

void printRow(const Case& reference, const Measurement& got, const Judgement& judgement, const Sharpness& sharpness) {
    std::printf("  %-48s %12.8g %12.8g %10.2g %6.2f %8.3f %%  %-10s %s\n", reference.name.c_str(), reference.expected,
                got.value, got.standardError, judgement.z, 100 * judgement.detects, sentence(judgement.verdict),
                reference.source.c_str());
    if (judgement.verdict == Verdict::tooBlunt)
        std::printf("  %48s it must be able to find a bias of %.3f %%\n", "", 100 * sharpness.detects);
    for (int i = 0; i < kFaults; ++i)
        if (const FaultCount& fault = got.health.faults[i]; fault.count > 0)
            std::printf("  %48s %s: %llu times, first in sample %llu of pixel %u\n", "", kFaultNames[i],
                        static_cast<unsigned long long>(fault.count), static_cast<unsigned long long>(fault.sample),
                        fault.pixel);
    std::fflush(stdout);
}

void printEnd(const Tally& tally, double seconds, bool brokenOff) {
    if (brokenOff)
        std::printf("\nBroken off after %d cases: this says nothing about the rest.", tally.all());
    std::printf("\n%d of %d cases agree with physics (%.0f s)", tally.agrees, tally.all(), seconds);
    if (tally.failed() > 0)
        std::printf("; FAILED: %d deviate, %d are too noisy to tell, %d had faulty samples", tally.deviates,
                    tally.tooBlunt, tally.faulty);
    std::printf(".\n");
}

}  // namespace pdr::selftest
