#pragma once
/// Cuts that are made from where one looks, as edits of the document.

#include <QObject>

#include "app/document/document.h"

namespace pdr::app {

class CutEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` outlives it.
    explicit CutEdits(Document& document) : document_(document) {}

  public slots:
    /// A plane through the middle that cuts off what is nearer to the viewer. `axis`: 0 sagittal, 1 coronal, 2 axial,
    /// -1 facing the viewer. Nothing where there are as many as can be.
    void addPlane(int axis);
    void addFreehand(const pdr::FreehandCut& cut);
    /// Nothing is cut any more; where nothing was, it is no step to undo.
    void undoAll();

  private:
    Document& document_;
};

}  // namespace pdr::app
