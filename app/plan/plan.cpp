#include "app/plan/plan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

namespace pdr::app {
namespace {

/// The names of a step in the Edit menu.
struct StepName {
    Text undo, redo;
};

/// A part of a plan.
struct Part {
    Changes change;
    bool (*differs)(const Plan& a, const Plan& b);
    StepName name;  ///< name of a step that changes this part alone; empty: it depends on the values, see nameOf()
};

/// Returns whether two looks agree in all but tissue, light, visible part, noise of the CT and parts.
bool agreeOtherwise(Look a, const Look& b) {
    a.transferFunction = b.transferFunction;
    a.rig = b.rig;
    a.environment = b.environment;
    a.visible = b.visible;
    a.ctDenoised = b.ctDenoised;
    a.parts = b.parts;
    return a == b;
}

/// The parts of a plan. A new member of Plan gets its row here.
const std::vector<Part>& parts() {
    static const std::vector<Part> all{
        {Changes::lookName,
         [](const Plan& a, const Plan& b) { return a.image.lookName != b.image.lookName; },
         {phrase("Undo choosing a look"), phrase("Redo choosing a look")}},
        {Changes::tissue,
         [](const Plan& a, const Plan& b) { return a.image.look.transferFunction != b.image.look.transferFunction; },
         {phrase("Undo editing the tissue"), phrase("Redo editing the tissue")}},
        {Changes::light,
         [](const Plan& a, const Plan& b) {
             return a.image.look.rig != b.image.look.rig || a.image.look.environment != b.image.look.environment;
         },
         {phrase("Undo changing the light"), phrase("Redo changing the light")}},
        {Changes::visible,
         [](const Plan& a, const Plan& b) { return a.image.look.visible != b.image.look.visible; },
         {phrase("Undo choosing the visible part"), phrase("Redo choosing the visible part")}},
        {Changes::ctDenoised,
         [](const Plan& a, const Plan& b) { return a.image.look.ctDenoised != b.image.look.ctDenoised; },
         {phrase("Undo switching CT denoising"), phrase("Redo switching CT denoising")}},
        {Changes::partStyles,
         [](const Plan& a, const Plan& b) { return a.image.look.parts != b.image.look.parts; },
         {phrase("Undo changing how a part is shown"), phrase("Redo changing how a part is shown")}},
        {Changes::otherLook,
         [](const Plan& a, const Plan& b) { return !agreeOtherwise(a.image.look, b.image.look); },
         {}},
        {Changes::brightness,
         [](const Plan& a, const Plan& b) { return a.image.stops != b.image.stops; },
         {phrase("Undo changing the brightness"), phrase("Redo changing the brightness")}},
        {Changes::camera, [](const Plan& a, const Plan& b) { return a.image.camera != b.image.camera; }, {}},
        {Changes::background,
         [](const Plan& a, const Plan& b) { return a.image.background != b.image.background; },
         {phrase("Undo changing the background"), phrase("Redo changing the background")}},
        {Changes::table, [](const Plan& a, const Plan& b) { return a.image.table != b.image.table; }, {}},
        {Changes::clip,
         [](const Plan& a, const Plan& b) { return a.image.clip != b.image.clip; },
         {phrase("Undo cutting"), phrase("Redo cutting")}},
        {Changes::model,
         [](const Plan& a, const Plan& b) { return a.image.model != b.image.model; },
         {phrase("Undo choosing an optical model"), phrase("Redo choosing an optical model")}},
        {Changes::rendering,
         [](const Plan& a, const Plan& b) {
             return a.image.estimator != b.image.estimator || a.image.schedule != b.image.schedule;
         },
         {phrase("Undo changing the rendering"), phrase("Redo changing the rendering")}},
        {Changes::crosshair,
         [](const Plan& a, const Plan& b) { return a.navigation.crosshairMm != b.navigation.crosshairMm; },
         {}},
        {Changes::framing,
         [](const Plan& a, const Plan& b) { return a.navigation.framings != b.navigation.framings; },
         {}},
        {Changes::window,
         [](const Plan& a, const Plan& b) { return a.navigation.window != b.navigation.window; },
         {phrase("Undo changing the window"), phrase("Redo changing the window")}},
        {Changes::layout,
         [](const Plan& a, const Plan& b) { return a.navigation.layout != b.navigation.layout; },
         {phrase("Undo changing the layout"), phrase("Redo changing the layout")}},
        {Changes::partSources, [](const Plan& a, const Plan& b) { return a.partSources != b.partSources; }, {}},
        {Changes::measurements, [](const Plan& a, const Plan& b) { return a.measurements != b.measurements; }, {}},
    };
    return all;
}

bool sameWay(dvec3 a, dvec3 b) {
    constexpr double kSame = 1e-9;  // radians: less than any gesture
    return glm::length(a - b) < kSame;
}

double distanceOf(const Camera& camera) {
    return glm::length(camera.targetMm - camera.eyeMm);
}

StepName nameOf(const Camera& before, const Camera& after) {
    if (!sameWay(before.forward(), after.forward()) || !sameWay(before.imageUp(), after.imageUp()))
        return {phrase("Undo turning the view"), phrase("Redo turning the view")};
    constexpr double kSame = 1e-9;
    const bool sameSize = before.fovDegrees == after.fovDegrees && before.heightMm == after.heightMm;
    if (!sameSize || std::abs(distanceOf(before) / distanceOf(after) - 1) > kSame)
        return {phrase("Undo zooming"), phrase("Redo zooming")};
    if (before.apertureMm != after.apertureMm || before.focusMm != after.focusMm || before.type != after.type)
        return {phrase("Undo changing the lens"), phrase("Redo changing the lens")};
    return {phrase("Undo moving the view"), phrase("Redo moving the view")};
}

std::vector<Measurement> withoutNames(std::vector<Measurement> measurements) {
    for (Measurement& measurement : measurements)
        measurement.name.clear();
    return measurements;
}

StepName nameOf(const std::vector<Measurement>& before, const std::vector<Measurement>& after) {
    if (after.size() > before.size() && after.back().kind == MeasureKind::point)
        return {phrase("Undo marking a place"), phrase("Redo marking a place")};
    if (after.size() > before.size())
        return {phrase("Undo measuring"), phrase("Redo measuring")};
    if (after.size() < before.size())
        return {phrase("Undo removing a measurement"), phrase("Redo removing a measurement")};
    if (withoutNames(before) == withoutNames(after))
        return {phrase("Undo naming a measurement"), phrase("Redo naming a measurement")};
    return {phrase("Undo changing a measurement"), phrase("Redo changing a measurement")};
}

/// Returns the parts that a step is named after. A look that was chosen stands for all that it brings, and so does one
/// that differs in several parts.
Changes namedParts(Changes changes) {
    const Changes look = changes & Changes::look;
    if (has(look, Changes::lookName))
        return (changes & ~(Changes::look | Changes::brightness)) | Changes::lookName;
    constexpr Changes kParts[]{Changes::tissue, Changes::light, Changes::visible, Changes::ctDenoised,
                               Changes::partStyles};
    const bool onePart = std::ranges::find(kParts, look) != std::end(kParts);
    return look == Changes::none || onePart ? changes : (changes & ~Changes::look) | Changes::lookName;
}

StepName nameOf(const Plan& before, const Plan& after) {
    const Changes changes = namedParts(changesBetween(before, after));
    if (changes == Changes::none)
        return {phrase("Undo"), phrase("Redo")};
    if (changes == Changes::camera)
        return nameOf(before.image.camera, after.image.camera);
    if (changes == Changes::measurements)
        return nameOf(before.measurements, after.measurements);
    if (changes == Changes::partSources)
        return after.partSources.empty() ? StepName{phrase("Undo removing parts"), phrase("Redo removing parts")}
                                         : StepName{phrase("Undo adding parts"), phrase("Redo adding parts")};
    if (!has(changes, ~Changes::navigation) && changes != Changes::window && changes != Changes::layout)
        return {phrase("Undo moving through the slices"), phrase("Redo moving through the slices")};
    if (changes == Changes::table && after.image.table == Table::shown)
        return {phrase("Undo showing the table"), phrase("Redo showing the table")};
    if (changes == Changes::table)
        return {phrase("Undo hiding the table"), phrase("Redo hiding the table")};
    const auto part = std::ranges::find(parts(), changes, &Part::change);
    return part == parts().end() ? StepName{phrase("Undo several changes"), phrase("Redo several changes")}
                                 : part->name;
}

}  // namespace

Changes changesBetween(const Plan& before, const Plan& after) {
    Changes changes = Changes::none;
    for (const Part& part : parts())
        if (part.differs(before, after))
            changes |= part.change;
    return changes;
}

Text undoText(const Plan& before, const Plan& after) {
    return nameOf(before, after).undo;
}

Text redoText(const Plan& before, const Plan& after) {
    return nameOf(before, after).redo;
}

}  // namespace pdr::app
