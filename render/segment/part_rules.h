#pragma once
/// The rules that find parts in a scan itself, and their names in options and scene files.

#include <set>
#include <string>
#include <string_view>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_map.h"
#include "render/volume/volume.h"

namespace pdr::segment {

enum class PartRule {
    vessels,  ///< vessels.h
    shells,   ///< skin and muscle (shells.h)
    mirror,   ///< bone that the other side has (mirrored_bone.h)
    metal     ///< implants (implants.h)
};

using PartRules = std::set<PartRule>;

/// Returns the rules of a list of names: "vessels,shells". Errors: a name that is none.
Result<PartRules> partRulesFrom(std::string_view names);
/// Returns the list that partRulesFrom() reads; empty without rules.
std::string partRulesText(const PartRules& rules);

/// Finds what a rule finds. Errors: the rule's.
Result<LabelMap> findParts(PartRule rule, const Volume& volume, const Progress& progress);
/// Finds what all of `rules` find, of which there is at least one. Of voxels in several parts the smallest part keeps
/// them. Errors: the first rule's that has one.
Result<LabelMap> findParts(const PartRules& rules, const Volume& volume, const Progress& progress);

}  // namespace pdr::segment
