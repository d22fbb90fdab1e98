#include "render/segment/part_rules.h"

#include <algorithm>
#include <array>
#include <utility>

#include "render/segment/implants.h"
#include "render/segment/mirrored_bone.h"
#include "render/segment/shells.h"
#include "render/segment/vessels.h"
#include "render/volume/joined_labels.h"

namespace pdr::segment {
namespace {

constexpr std::array kNames{
    std::pair{PartRule::vessels, std::string_view("vessels")}, std::pair{PartRule::shells, std::string_view("shells")},
    std::pair{PartRule::mirror, std::string_view("mirror")}, std::pair{PartRule::metal, std::string_view("metal")}};
constexpr std::string_view kAllNames = "vessels, shells, mirror, metal";

}  // namespace

Result<PartRules> partRulesFrom(std::string_view names) {
    PartRules rules;
    for (bool more = true; more;) {
        const std::size_t comma = names.find(',');
        const std::string_view name = names.substr(0, comma);
        const auto* rule = std::ranges::find(kNames, name, [](const auto& one) { return one.second; });
        if (rule == kNames.end())
            return Error{
                phrase("must be of %1, with commas between, not \"%2\"", std::string(kAllNames), std::string(name))};
        rules.insert(rule->first);
        more = comma != std::string_view::npos;
        names.remove_prefix(more ? comma + 1 : names.size());
    }
    return rules;
}

std::string partRulesText(const PartRules& rules) {
    std::string text;
    for (const auto& [rule, name] : kNames) {
        if (!rules.contains(rule))
            continue;
        if (!text.empty())
            text += ',';
        text += name;
    }
    return text;
}

Result<LabelMap> findParts(PartRule rule, const Volume& volume, const Progress& progress) {
    switch (rule) {
        case PartRule::shells:
            return findShells(volume, nullptr, progress);
        case PartRule::mirror:
            return findMirroredBone(volume, progress);
        case PartRule::metal:
            return findImplants(volume, progress);
        case PartRule::vessels:
            break;
    }
    return findVessels(volume, progress);
}

Result<LabelMap> findParts(const PartRules& rules, const Volume& volume, const Progress& progress) {
    JoinedLabels all;
    double done = 0;
    for (const PartRule rule : rules) {
        const double before = done;
        done += 1 / double(rules.size());
        Result<LabelMap> map = findParts(rule, volume, partOf(progress, before, done));
        if (!map || rules.size() == 1)
            return map;
        if (auto ok = all.add(*std::move(map)); !ok)
            return ok.error();
    }
    return all.take();
}

}  // namespace pdr::segment
