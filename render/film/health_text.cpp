#include "render/film/health_text.h"

namespace pdr {

const char* faultText(Fault fault) {
    switch (fault) {
        case Fault::notANumber:
            return "samples left out: not a number";
        case Fault::infinite:
            return "samples left out: infinitely bright";
        case Fault::negative:
            return "samples left out: negative light";
        case Fault::overMajorant:
            return "meetings with tissue above its bound";
        case Fault::cutPath:
            return "light paths cut off at their last allowed event";
        case Fault::overTolerance:
            break;
    }
    return "rays less exact than asked for";
}

std::vector<Text> healthLines(const Health& health) {
    std::vector<Text> lines;
    for (int i = 0; i < kFaults; ++i)
        if (health.faults[i].count > 0)
            lines.push_back(phrase("%1 %2", health.faults[i].count, faultText(Fault(i))));
    return lines;
}

}  // namespace pdr
