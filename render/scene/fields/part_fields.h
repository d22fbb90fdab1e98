#pragma once
/// Names, ranges and meanings of the fields of how parts are shown.

#include "render/scene/fields/tissue_fields.h"
#include "render/scene/part_styles.h"

namespace pdr {

inline constexpr Words<PartState, 3> kPartStateWords{
    {{"shown", PartState::shown}, {"ghost", PartState::ghost}, {"hidden", PartState::hidden}}};

template <class Visit>
void describe(Visit& visit, PartStyle& style) {
    visit({"part", "name of the part, or of several", {}, kRequired}, style.part);
    visit.word({"state", "`shown`, as a `ghost`, with at most 0.01 per mm, or `hidden`"}, style.state, kPartStateWords);
    visit({"colour", "colour: albedo in place of the curve's", kFraction}, style.colour);
    visit.object({"transferFunction", "a curve of its own"}, style.transferFunction);
    visit({"look", "name of the look that has that curve"}, style.look);
}

template <class Visit>
void describe(Visit& visit, PartStyles& styles) {
    visit.word({"rest", "how tissue in no part is shown"}, styles.rest, kPartStateWords);
    visit({"inColour", "whether parts without a colour have that of the label map"}, styles.inColour);
    visit.list({"styles", "of parts that are not shown as all tissue is"}, styles.styles);
}

}  // namespace pdr
