#include "dicom/stack/value_range.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "dicom/parallel.h"
#include "dicom/read/open_images.h"
#include "dicom/read/refusal.h"

namespace pdr::dicom {

namespace {

using Slices = std::vector<const SliceHeader*>;

bool isWhole(double number) {
    return number == std::floor(number);
}

/// Returns whether the range of a slice's values is known only when its pixels have been read.
bool isWide(const SliceHeader& slice) {
    return !isInHu(slice) && (slice.realBits != 0 || slice.format.bitsStored > 16);
}

ValueRange possibleValues(const SliceHeader& slice) {
    const double slope = slice.meaning.slope.value_or(1), intercept = slice.meaning.intercept.value_or(0);
    const double count = std::exp2(slice.format.bitsStored), lowest = slice.format.isSigned ? -count / 2 : 0;
    double first = lowest, last = lowest + count - 1;
    if (const ValueTable* table = slice.meaning.table.get()) {
        const auto [least, most] = std::ranges::minmax_element(table->values);
        first = *least, last = *most;
    }
    first = slope * first + intercept, last = slope * last + intercept;
    return {std::min(first, last), std::max(first, last), isWhole(slope) && isWhole(intercept)};
}

}  // namespace

ValueRange possibleValues(const Slices& slices) {
    ValueRange all = ValueRange::none();
    for (const SliceHeader* slice : slices)
        all.include(possibleValues(*slice));
    return all;
}

ValueRange valueRange(const Slices& slices, const SeriesSource& source, const Progress& progress) {
    if (std::ranges::none_of(slices, [](const auto* slice) { return isWide(*slice); }))
        return possibleValues(slices);
    OpenImages images(source);
    ValueRange all = ValueRange::none();
    std::mutex mutex;
    const auto measure = [&](std::size_t i, const GoOn& goOn) {
        const SliceHeader& slice = *slices[i];
        ValueRange range = ValueRange::none();
        if (!isWide(slice))
            range = possibleValues(slice);
        else if (const auto decoded = images.decode(slice.file, slice.frame, Padding::keep, goOn))
            range = decoded->values;
        const std::lock_guard lock(mutex);
        all.include(range);
    };
    onAllCores(slices.size(), measure, progress, "reading values");
    return all;
}

}  // namespace pdr::dicom
