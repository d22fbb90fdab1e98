#include "app/presenters/annotating.h"

#include <utility>

#include "app/presenters/look_text.h"
#include "render/scene/not_shown.h"
#include "render/smooth/non_local_means.h"
#include "ui/annotation/annotation_text.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

ui::Annotations annotations(const Workspace& workspace, const Camera& camera, const std::string& lookName,
                            ui::ImageFacts facts) {
    facts.look = nameText(workspace.document.looks(), lookName);
    facts.uncut = workspace.document.uncut();
    return {camera, workspace.window.patient(), ui::annotationTexts(facts)};
}

}  // namespace

ui::Annotations annotationsOf(const Workspace& workspace, const Frame& frame) {
    return annotations(workspace, frame.camera, frame.lookName,
                       {{}, frame.maskAwaited, ui::inWords(frame.notShown), frame.clip, {}, frame.ctDenoised});
}

ui::Annotations annotationsOf(const Workspace& workspace, const Scene& scene) {
    return annotations(
        workspace, scene.camera, scene.lookName,
        {{}, scene.maskAwaited, ui::inWords(notShown(scene)), scene.clip, {}, isCtDenoised(*scene.volume)});
}

std::optional<ui::Annotations> leaving(ui::Annotations all, ui::Annotate choice) {
    if (choice == ui::Annotate::none)
        return std::nullopt;
    if (choice != ui::Annotate::patient)
        all.patient.clear();
    return all;
}

}  // namespace pdr::app
