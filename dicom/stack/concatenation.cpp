#include "dicom/stack/concatenation.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace pdr::dicom {

namespace {

/// The parts of one concatenation that are there.
struct Parts {
    std::set<int> numbers;
    int count = 0;  ///< as stated, or as far as is known
};

}  // namespace

Text missingPart(const std::vector<const SliceHeader*>& slices) {
    std::map<std::string, Parts> all;
    for (const SliceHeader* slice : slices) {
        const Concatenation& place = slice->concatenation;
        if (place.uid.empty())
            continue;
        Parts& parts = all[place.uid];
        parts.numbers.insert(place.part);
        parts.count = std::max({parts.count, place.parts, place.part});
    }
    for (const auto& [uid, parts] : all)
        for (int part = 1; part <= parts.count; ++part)
            if (!parts.numbers.contains(part))
                return phrase("part %1 of %2 is missing of an image that is stored in several files (a concatenation)",
                              part, parts.count);
    return {};
}

}  // namespace pdr::dicom
