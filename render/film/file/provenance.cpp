#include "render/film/file/provenance.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace pdr {

namespace {

std::string text(const std::string& words) {
    return words;
}
std::string text(double number) {
    if (!std::isfinite(number))
        return "unknown";
    std::ostringstream out;
    out.precision(9);
    out << number;
    return out.str();
}

/// Returns the faults as text, "notANumber 0, infinite 2 (pixel 17, sample 3), ...": each cause with the first
/// sample that it happened to.
std::string healthFact(const Health& health) {
    std::string fact;
    for (int i = 0; i < kFaults; ++i) {
        const FaultCount& fault = health.faults[i];
        fact += (i > 0 ? ", " : "") + std::string(kFaultNames[i]) + " " + std::to_string(fault.count);
        if (fault.count > 0)
            fact += " (pixel " + std::to_string(fault.pixel) + ", sample " + std::to_string(fault.sample) + ")";
    }
    return fact;
}

}  // namespace

std::vector<Fact> factsOf(const Provenance& from) {
    const FilmStatus& status = from.status;
    const bool isUneven = status.mostSamplesPerPixel > status.samplesPerPixel;
    std::vector<Fact> facts{
        {"pdrender/samplesPerPixel", double(status.samplesPerPixel)},
        {"pdrender/mostSamplesPerPixel", isUneven ? std::to_string(status.mostSamplesPerPixel) : std::string()},
        {"pdrender/seconds", from.seconds},
        {"pdrender/relativeError", status.relativeError},
        {"pdrender/tissueWithinLevels", status.displayError},  // 95 % of the tissue, of 255 levels
        {"pdrender/tissueNotSeenYet", status.unseenTissue},    // a lower bound
        {"pdrender/exposure", from.exposure},
        {"pdrender/toneCurve", from.toneCurve},
        {"pdrender/bias", from.bias.empty() ? "none known" : from.bias},
        {"pdrender/rejectedSamples", double(status.health.rejected())},
        {"pdrender/health", healthFact(status.health)},
        {"pdrender/seed", std::to_string(from.seed)},  // 64 bits do not fit a double
        {"pdrender/model", from.model},
        {"pdrender/extinctionPerMm", from.extinctionPerMm},
        {"pdrender/program", from.program},
        {"pdrender/device", from.device},
        {"pdrender/nodes", from.nodes},
        {"pdrender/effects", from.effects},
        {"pdrender/look", from.look},
        {"pdrender/sky", from.sky},
        {"pdrender/camera", from.camera},
        {"pdrender/estimator", from.estimator},
        {"pdrender/schedule", from.schedule},
        {"pdrender/warnings", from.warnings},
        {"pdrender/hidden", from.hidden},
        {"pdrender/cut", from.cut},
        {"pdrender/notShown", from.notShown},
        {"pdrender/remarks", from.remarks},
    };
    std::erase_if(facts, [](const Fact& fact) { return fact.value == std::variant<std::string, double>(); });
    return facts;
}

std::string textOf(const Fact& fact) {
    return std::visit([](const auto& value) { return text(value); }, fact.value);
}

}  // namespace pdr
