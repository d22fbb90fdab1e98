#include "app/document/step_name.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace pdr::app {
namespace {

struct StepName {
    Q_DECLARE_TR_FUNCTIONS(StepName)

  public:
    Change change;
    const char* undo;
    const char* redo;
};

const auto kNames = std::to_array<StepName>({
    {Change::nothing, QT_TRANSLATE_NOOP("StepName", "Undo"), QT_TRANSLATE_NOOP("StepName", "Redo")},
    {Change::turned, QT_TRANSLATE_NOOP("StepName", "Undo turning the view"),
     QT_TRANSLATE_NOOP("StepName", "Redo turning the view")},
    {Change::moved, QT_TRANSLATE_NOOP("StepName", "Undo moving the view"),
     QT_TRANSLATE_NOOP("StepName", "Redo moving the view")},
    {Change::zoomed, QT_TRANSLATE_NOOP("StepName", "Undo zooming"), QT_TRANSLATE_NOOP("StepName", "Redo zooming")},
    {Change::lens, QT_TRANSLATE_NOOP("StepName", "Undo changing the lens"),
     QT_TRANSLATE_NOOP("StepName", "Redo changing the lens")},
    {Change::tableShown, QT_TRANSLATE_NOOP("StepName", "Undo showing the table"),
     QT_TRANSLATE_NOOP("StepName", "Redo showing the table")},
    {Change::tableHidden, QT_TRANSLATE_NOOP("StepName", "Undo hiding the table"),
     QT_TRANSLATE_NOOP("StepName", "Redo hiding the table")},
    {Change::lookChosen, QT_TRANSLATE_NOOP("StepName", "Undo choosing a look"),
     QT_TRANSLATE_NOOP("StepName", "Redo choosing a look")},
    {Change::tissue, QT_TRANSLATE_NOOP("StepName", "Undo editing the tissue"),
     QT_TRANSLATE_NOOP("StepName", "Redo editing the tissue")},
    {Change::light, QT_TRANSLATE_NOOP("StepName", "Undo changing the light"),
     QT_TRANSLATE_NOOP("StepName", "Redo changing the light")},
    {Change::visible, QT_TRANSLATE_NOOP("StepName", "Undo choosing the visible part"),
     QT_TRANSLATE_NOOP("StepName", "Redo choosing the visible part")},
    {Change::brightness, QT_TRANSLATE_NOOP("StepName", "Undo changing the brightness"),
     QT_TRANSLATE_NOOP("StepName", "Redo changing the brightness")},
    {Change::background, QT_TRANSLATE_NOOP("StepName", "Undo changing the background"),
     QT_TRANSLATE_NOOP("StepName", "Redo changing the background")},
    {Change::cut, QT_TRANSLATE_NOOP("StepName", "Undo cutting"), QT_TRANSLATE_NOOP("StepName", "Redo cutting")},
    {Change::model, QT_TRANSLATE_NOOP("StepName", "Undo choosing an optical model"),
     QT_TRANSLATE_NOOP("StepName", "Redo choosing an optical model")},
    {Change::rendering, QT_TRANSLATE_NOOP("StepName", "Undo changing the rendering"),
     QT_TRANSLATE_NOOP("StepName", "Redo changing the rendering")},
    {Change::several, QT_TRANSLATE_NOOP("StepName", "Undo several changes"),
     QT_TRANSLATE_NOOP("StepName", "Redo several changes")},
});

const StepName& nameOf(Change change) {
    return *std::ranges::find(kNames, change, &StepName::change);
}

bool sameWay(dvec3 a, dvec3 b) {
    constexpr double kSame = 1e-9;  // radians: less than any gesture
    return glm::length(a - b) < kSame;
}

double distanceOf(const Camera& camera) {
    return glm::length(camera.targetMm - camera.eyeMm);
}

Change changeOf(const Camera& before, const Camera& after) {
    if (!sameWay(before.forward(), after.forward()) || !sameWay(before.imageUp(), after.imageUp()))
        return Change::turned;
    constexpr double kSame = 1e-9;
    const bool sameSize = before.fovDegrees == after.fovDegrees && before.heightMm == after.heightMm;
    if (!sameSize || std::abs(distanceOf(before) / distanceOf(after) - 1) > kSame)
        return Change::zoomed;
    if (before.apertureMm != after.apertureMm || before.focusMm != after.focusMm || before.type != after.type)
        return Change::lens;
    return Change::moved;
}

Change changeOf(const Look& before, const Look& after) {
    Look tissue = before, light = before, visible = before;
    tissue.transferFunction = after.transferFunction;
    light.rig = after.rig;
    light.environment = after.environment;
    visible.visible = after.visible;
    if (tissue == after)
        return Change::tissue;
    if (visible == after)
        return Change::visible;
    return light == after ? Change::light : Change::lookChosen;
}

}  // namespace

Change changeOf(const PictureSetup& before, const PictureSetup& after) {
    std::vector<Change> changes;
    const bool chosen = before.lookName != after.lookName;
    if (chosen)
        changes.push_back(Change::lookChosen);
    else if (before.look != after.look)
        changes.push_back(changeOf(before.look, after.look));
    if (before.stops != after.stops && !chosen)
        changes.push_back(Change::brightness);
    if (before.background != after.background)
        changes.push_back(Change::background);
    if (before.camera != after.camera)
        changes.push_back(changeOf(before.camera, after.camera));
    if (before.table != after.table)
        changes.push_back(after.table == Table::shown ? Change::tableShown : Change::tableHidden);
    if (before.clip != after.clip)
        changes.push_back(Change::cut);
    if (before.model != after.model)
        changes.push_back(Change::model);
    if (before.estimator != after.estimator || before.schedule != after.schedule)
        changes.push_back(Change::rendering);
    if (changes.empty())
        return Change::nothing;
    return changes.size() == 1 ? changes.front() : Change::several;
}

QString undoText(Change change) {
    return StepName::tr(nameOf(change).undo);
}

QString redoText(Change change) {
    return StepName::tr(nameOf(change).redo);
}

}  // namespace pdr::app
