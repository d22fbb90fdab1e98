#pragma once
/// Cuts that depend on the camera, as edits of the document.

#include <QObject>

#include "app/document/document.h"

namespace pdr::app {

class CutEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` must outlive this object.
    explicit CutEdits(Document& document) : document_(document) {}

  public slots:
    /// Adds a plane through the middle of the uncut box that cuts off the side nearer to the viewer. `axis`: 0
    /// sagittal, 1 coronal, 2 axial, -1 facing the viewer. Does nothing without a volume, or if there are kMostPlanes
    /// already.
    void addPlane(int axis);
    void addFreehand(const pdr::FreehandCut& cut);
    /// Removes all cuts. No step to undo if there were none.
    void undoAll();

  private:
    Document& document_;
};

}  // namespace pdr::app
