#pragma once
/// Reads the values of single elements of a parsed object, without trusting their form.

#include <array>
#include <optional>
#include <string>

class DcmItem;
class DcmTagKey;

namespace pdr::dicom {

/// Returns one value of a decimal string; none if it is not there, or no number from end to end: "1,5" must not pass as
/// 1.
std::optional<double> numberAt(DcmItem& item, const DcmTagKey& tag, int index);

/// Returns the values of a decimal string; none if it is absent, shorter or not all numbers.
template <int Count>
std::optional<std::array<double, Count>> numbers(DcmItem& item, const DcmTagKey& tag) {
    std::array<double, Count> values;
    for (int i = 0; i < Count; ++i) {
        const std::optional<double> value = numberAt(item, tag, i);
        if (!value)
            return {};
        values[i] = *value;
    }
    return values;
}

int shortValue(DcmItem& item, const DcmTagKey& tag, int absent);
int integerValue(DcmItem& item, const DcmTagKey& tag, int absent);

/// Returns all values of an element, joined by backslashes, without spaces at their end; at most 512 bytes.
std::string text(DcmItem& item, const DcmTagKey& tag);

}  // namespace pdr::dicom
