#pragma once
/// Labels: the names of the parts of a patient that an image can show alone or leave out. Files, options and masks name
/// a part by its label.

#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "render/base/text.h"

namespace pdr::segment {

/// A set of labels, in alphabetical order.
using Labels = std::set<std::string, std::less<>>;

/// The parts that rules of density and geometry find in a scan (body_parts.h).
inline constexpr std::string_view kBones = "bones", kLungs = "lungs";
inline constexpr std::string_view kFoundLabels[] = {kBones, kLungs};

/// Returns the part's name within a sentence: "the lungs". A label that no rule finds is its own name.
Text partName(std::string_view label);
/// Returns the names as a list within a sentence: "bones and the lungs". `labels` must not be empty.
Text partNames(const Labels& labels);

}  // namespace pdr::segment
