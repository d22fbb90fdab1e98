#include "app/desktop/annotating.h"

#include <utility>

#include "app/desktop/look_text.h"
#include "ui/annotation/annotation_text.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

ui::Annotations annotations(const DesktopParts& parts, const Camera& camera, const std::string& lookName,
                            ui::ImageFacts facts) {
    facts.look = nameText(parts.document.looks(), lookName);
    facts.uncut = parts.document.uncut();
    return {camera, parts.window.patient(), ui::annotationTexts(facts)};
}

}  // namespace

ui::Annotations annotationsOf(const DesktopParts& parts, const Frame& frame) {
    return annotations(parts, frame.camera, frame.lookName,
                       {{}, frame.maskAwaited, ui::inWords(frame.notShown), frame.clip, {}});
}

ui::Annotations annotationsOf(const DesktopParts& parts, const Scene& scene) {
    const Text notShown = scene.mask ? scene.mask->hidden() : Text();
    return annotations(parts, scene.camera, scene.lookName,
                       {{}, scene.maskAwaited, ui::inWords(notShown), scene.clip, {}});
}

std::optional<ui::Annotations> leaving(ui::Annotations all, ui::Annotate choice) {
    if (choice == ui::Annotate::none)
        return std::nullopt;
    if (choice != ui::Annotate::patient)
        all.patient.clear();
    return all;
}

ui::Annotate usualAnnotate(const DesktopParts& parts) {
    return parts.bridge.captioned() ? ui::Annotate::sides : ui::Annotate::none;
}

}  // namespace pdr::app
