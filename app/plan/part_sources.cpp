#include "app/plan/part_sources.h"

#include <span>
#include <string_view>

#include "app/wire/content_hash.h"

namespace pdr::app {

namespace {

struct RuleOf {
    PartRule rule;
    int PartSources::*version;  ///< the one that is wanted
    int present;                ///< the newest one
};
constexpr RuleOf kRules[] = {{PartRule::vessels, &PartSources::vessels, kVesselsRule},
                             {PartRule::shells, &PartSources::shells, kShellsRule},
                             {PartRule::mirror, &PartSources::mirror, kMirrorRule},
                             {PartRule::metal, &PartSources::metal, kMetalRule}};

}  // namespace

segment::PartRules rulesOf(const PartSources& sources) {
    segment::PartRules rules;
    for (const RuleOf& one : kRules)
        if (sources.*one.version != 0)
            rules.insert(one.rule);
    return rules;
}

PartSources withRule(PartSources sources, PartRule rule) {
    for (const RuleOf& one : kRules)
        if (one.rule == rule)
            sources.*one.version = one.present;
    return sources;
}

std::string labelsHash(const LabelMap& map) {
    constexpr std::string_view kKey = "label map";
    constexpr std::size_t kBytes = 16;
    wire::ContentHash hash(std::as_bytes(std::span(kKey)));
    for (const MappedPart& part : map.parts)
        hash.add(std::as_bytes(std::span(part.name.c_str(), part.name.size() + 1)));
    hash.add(std::as_bytes(std::span(map.labels)));
    const wire::Hash whole = hash.finish();
    constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    for (const std::byte byte : std::span(whole).first(kBytes))
        text += {kDigits[std::size_t(byte) >> 4], kDigits[std::size_t(byte) & 15]};
    return text;
}

}  // namespace pdr::app
