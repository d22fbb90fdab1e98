#include "app/presenters/part_rows.h"

#include <algorithm>
#include <cmath>

#include "app/presenters/look_text.h"
#include "render/segment/found_parts.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"
#include "ui/widgets/screen_colour.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Parts)
};

QString stateText(PartState state) {
    switch (state) {
        case PartState::ghost:
            return Texts::tr("ghost");
        case PartState::hidden:
            return Texts::tr("hidden");
        case PartState::shown:
            break;
    }
    return Texts::tr("shown");
}

QColor colourOf(const MappedPart& part, const PartStyle& style) {
    return style.colour ? ui::screenColour(*style.colour) : QColor(part.colour[0], part.colour[1], part.colour[2]);
}

QString volumeText(double ml) {
    return Texts::tr("%1 ml").arg(ui::number(ml, ml < 10 ? 1 : 0));
}

}  // namespace

std::vector<ui::PartRow> partRows(const Document& document) {
    std::vector<ui::PartRow> rows;
    const std::shared_ptr<const ScanParts>& parts = document.scanParts();
    if (!parts)
        return rows;
    const PartStyles& styles = document.setup().look.parts;
    rows.push_back({.name = Texts::tr("Rest of the body"), .state = stateText(styles.rest)});
    for (std::size_t i = 0; i < parts->facts.size(); ++i) {
        const MappedPart& part = parts->map->parts[i];
        const PartStyle style = styleOf(styles, part.name);
        const PartFacts& facts = parts->facts[i];
        rows.push_back({ui::inWords(segment::partTitle(part.name)), colourOf(part, style), volumeText(facts.ml),
                        stateText(style.state), facts.byRule ? Texts::tr("program") : Texts::tr("file"),
                        nameText(document.looks(), style.look), ui::sentence(facts.source)});
    }
    return rows;
}

SliceTint partTint(const Document& document) {
    const std::shared_ptr<const ScanParts>& parts = document.scanParts();
    if (!parts)
        return {};
    SliceTint tint{parts->map, {}};
    for (const MappedPart& part : parts->map->parts) {
        const PartStyle style = styleOf(document.setup().look.parts, part.name);
        const QColor colour = colourOf(part, style);
        tint.colours.push_back(style.state == PartState::hidden
                                   ? std::nullopt
                                   : std::optional(LabelColour{std::uint8_t(colour.red()), std::uint8_t(colour.green()),
                                                               std::uint8_t(colour.blue())}));
    }
    return tint;
}

/// Returns what lacks a part of that name.
static MissingParts missingOf(const std::string& part) {
    if (part == segment::kVessels)
        return MissingParts::vessels;
    if (part == segment::kSkin || part == segment::kMuscle)
        return MissingParts::shells;
    if (part == segment::kMirroredBone)
        return MissingParts::mirror;
    return part == segment::kImplant ? MissingParts::metal : MissingParts::labels;
}

MissingParts missingParts(const Document& document) {
    const std::shared_ptr<const ScanParts>& parts = document.scanParts();
    const PartStyles& styles = document.setup().look.parts;
    const bool awaited = !parts && !document.plan().partSources.empty();
    if (!document.hasVolume() || styles.empty() || awaited)
        return MissingParts::none;
    for (const PartStyle& style : styles.styles)
        if (!parts || std::ranges::find(parts->map->parts, style.part, &MappedPart::name) == parts->map->parts.end())
            return missingOf(style.part);
    return parts || !styles.inColour ? MissingParts::none : MissingParts::labels;
}

QString partNotes(const Document& document) {
    const std::shared_ptr<const ScanParts>& parts = document.scanParts();
    if (!parts)
        return {};
    QStringList notes;
    if (std::ranges::any_of(parts->facts, &PartFacts::byRule))
        notes << Texts::tr("Found by the program: check it.");
    for (const Text& note : parts->map->notes)
        notes << ui::sentence(note);
    if (!showsParts(document.setup().model))
        notes << Texts::tr("The optical model of this look shows no parts.");
    return notes.join(' ');
}

}  // namespace pdr::app
