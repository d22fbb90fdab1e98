#pragma once
/// Names, ranges and meanings of the fields of light rigs.

#include <optional>
#include <vector>

#include "render/scene/fields/ranges.h"
#include "render/scene/light_rig.h"

namespace pdr {

inline constexpr Words<LightRig::Follows, 2> kFollowsWords{
    {{"camera", LightRig::Follows::camera}, {"patient", LightRig::Follows::patient}}};

template <class Visit>
void describe(Visit& visit, RigPanel& panel) {
    visit({"name", "of the lamp; panels of one name are one lamp"}, panel.name);
    visit.direction({"from",
                     "where it stands, seen from the volume's centre: right, up, towards the viewer (of the view from "
                     "the front where the rig follows the patient)",
                     {},
                     kRequired},
                    panel.from);
    visit({"distance", "of its centre from the volume's [radii of the volume]", {1, 100}}, panel.distance);
    visit({"edge", "of the square [radii of the volume]", {1e-3, 100}}, panel.edge);
    visit({"radiance", "scale of `colour`", {0, RigPanel::kBrightest}, kRequired}, panel.radiance);
    visit({"colour", "of its light", {0, 1000}}, panel.colour);
}

/// The rig and the environment, which files store as one object.
struct RigFields {
    LightRig& rig;
    Environment& environment;
};

/// Describes the panels: files list all of them, or give the brightness of the standard ones.
template <class Visit>
void describePanels(Visit& visit, LightRig& rig) {
    constexpr Range kScale{0, RigPanel::kBrightest};
    const std::optional<vec3> standard = standardScales(rig);
    std::vector<RigPanel> panels;
    if (!standard)
        panels = rig.panels;
    if (Visit::kReads || Visit::kBranches || !standard)
        visit.list({"panels", "a list of 1 to 64 panels, each a square that faces the volume"}, panels);
    if (Visit::kReads && !panels.empty())
        rig.panels = panels;
    if (!panels.empty())
        return;
    vec3 scales = standard.value_or(vec3(0));
    visit({"key", "without `panels`: radiance scale of the main panel, upper left", kScale}, scales.x);
    visit({"fill", "likewise of the panel on the other side", kScale}, scales.y);
    visit({"rim", "likewise of the panel behind", kScale}, scales.z);
    if (Visit::kReads)
        rig.panels = standardPanels(scales.x, scales.y, scales.z);
}

template <class Visit>
void describe(Visit& visit, RigFields& fields) {
    constexpr Range kScale{0, 1e6};
    describePanels(visit, fields.rig);
    visit.word({"follows",
                "what the panels move with: the `camera`, so that each view is lit alike, or the `patient`, lit as in "
                "the view from the front"},
               fields.rig.follows, kFollowsWords);
    visit({"ambient", "colour: radiance of the environment; with `nadir`: from straight above (towards the head)",
           kScale},
          fields.environment.radiance);
    visit({"nadir", "colour from straight below; in between it changes evenly with the height", kScale},
          fields.environment.nadir);
    visit({"visible", "whether the camera sees the environment behind the volume"}, fields.environment.visible);
}

}  // namespace pdr
