#pragma once
/// The plan: everything that a user sets and can undo. A document holds one, with a history of earlier ones.

#include "app/plan/measurement.h"
#include "app/plan/navigation.h"
#include "app/plan/part_sources.h"
#include "render/base/text.h"
#include "render/scene/image_setup.h"

namespace pdr::app {

struct Plan {
    ImageSetup image;       ///< how the volume is shown and rendered
    Navigation navigation;  ///< where the slices lie, and how they are seen
    std::vector<Measurement> measurements;
    PartSources partSources;  ///< where the parts of the scan come from
    bool operator==(const Plan&) const = default;
};

/// Sets of changes, as flags: what an operation has changed, and what a gesture of the user edits.
enum class Changes : unsigned {
    none = 0,
    // Parts of a plan
    camera = 1 << 0,
    lookName = 1 << 1,
    tissue = 1 << 2,
    light = 1 << 3,
    visible = 1 << 4,
    otherLook = 1 << 5,  ///< what else a look sets, e.g. its phase function
    brightness = 1 << 6,
    background = 1 << 7,
    table = 1 << 8,
    clip = 1 << 9,
    model = 1 << 10,
    rendering = 1 << 11,  ///< estimator and schedule
    crosshair = 1 << 12,
    framing = 1 << 13,  ///< zoom and place of the slices in their views
    window = 1 << 14,   ///< the grey window of the slices
    measurements = 1 << 15,
    layout = 1 << 20,       ///< which views are shown, and where
    ctDenoised = 1 << 22,   ///< whether the CT is shown with less noise
    partStyles = 1 << 23,   ///< how parts of a label map are shown
    partSources = 1 << 24,  ///< where they come from
    // What a document holds beside its plan
    series = 1 << 16,   ///< a volume has been opened or closed
    arrival = 1 << 21,  ///< a volume is being read, and its slices can be seen
    looks = 1 << 17,    ///< the list of looks
    mask = 1 << 18,     ///< the mask of the visible part, the denoised CT or parts have arrived
    display = 1 << 19,  ///< whether the image is shown denoised
    // Groups
    look = lookName | tissue | light | visible | ctDenoised | partStyles | otherLook,
    navigation = crosshair | framing | window | layout,
    all = ~0u,
};

constexpr Changes operator|(Changes a, Changes b) {
    return Changes(unsigned(a) | unsigned(b));
}
constexpr Changes operator&(Changes a, Changes b) {
    return Changes(unsigned(a) & unsigned(b));
}
constexpr Changes operator~(Changes a) {
    return Changes(~unsigned(a));
}
constexpr Changes& operator|=(Changes& a, Changes b) {
    return a = a | b;
}
/// Returns whether `changes` has any of `those`.
constexpr bool has(Changes changes, Changes those) {
    return (changes & those) != Changes::none;
}

/// Returns the parts in which two plans differ. Whether a look counts as changed since it was chosen is no part of its
/// own: it follows from the look.
Changes changesBetween(const Plan& before, const Plan& after);

/// Returns a whole phrase for a menu on the step that turned `before` into `after`: "Undo turning the view". Choosing a
/// look includes its brightness. "Undo" alone if the plans are equal.
Text undoText(const Plan& before, const Plan& after);
/// Returns a whole phrase for a menu on the step that turned `before` into `after`: "Redo turning the view".
Text redoText(const Plan& before, const Plan& after);

}  // namespace pdr::app
