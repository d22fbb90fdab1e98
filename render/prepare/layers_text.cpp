#include "render/prepare/layers_text.h"

#include <cmath>

namespace pdr {

namespace {

Text perCent(double share) {
    return fixedNumber(100 * share, 0);
}

Text choiceText(const LayersUnder& under) {
    const Text share = perCent(under.heaviest()->share);
    if (under.layers.size() == 1)
        return phrase("only %1 % of the light here stops at one depth, which was taken", share);
    return phrase("the light here stops at %1 depths: the one with the most, %2 %, was taken",
                  fixedNumber(double(under.layers.size()), 0), share);
}

}  // namespace

Text layersText(const LayersUnder& under) {
    switch (under.seen) {
        case SeenAt::place:
            break;
        case SeenAt::choice:
            return choiceText(under);
        case SeenAt::fog:
            return phrase("what is seen here is spread over %1 mm of depth: too translucent to be one place",
                          fixedNumber(under.spreadMm, 0));
        case SeenAt::nothing:
            return phrase("no tissue at this point: %1 % of the light passes", perCent(1 - under.met));
        case SeenAt::everyDepth:
            return phrase("this image adds up all depths: no point of it is one place");
    }
    return {};
}

}  // namespace pdr
