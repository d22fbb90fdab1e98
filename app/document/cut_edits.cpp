#include "app/document/cut_edits.h"

#include "render/scene/edit/cut_handles.h"

namespace pdr::app {

void CutEdits::addPlane(int axis) {
    Clip clip = document_.setup().clip;
    const std::optional<ClipBox> uncut = document_.uncut();
    if (!uncut || clip.planes.size() >= kMostPlanes)
        return;
    const Camera& camera = document_.setup().camera;
    clip.planes.push_back(axis < 0 ? facingPlane(camera, *uncut) : planeAcross(axis, camera, *uncut));
    document_.setClip(clip);
}

void CutEdits::addFreehand(const FreehandCut& cut) {
    Clip clip = document_.setup().clip;
    clip.freehand.push_back(cut);
    document_.setClip(clip);
}

void CutEdits::undoAll() {
    document_.setClip({});
}

}  // namespace pdr::app
