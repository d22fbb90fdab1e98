#pragma once
/// Edits of the tissue's curves by the user, on the panel and on the image, as edits of the document.

#include <QObject>
#include <QPointF>
#include <optional>

#include "app/document/document.h"
#include "render/prepare/tissue_behind.h"

namespace pdr::app {

class TissueEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` must outlive this object.
    explicit TissueEdits(Document& document) : document_(document) {}

  public slots:
    /// Sets the transfer function. One gesture is one step to undo.
    void setTransferFunction(const pdr::TransferFunction& function, bool moving);
    /// Applies a drag on the image, measured from where it began, in fractions of the view's height. To the right it
    /// shifts all curves up by 1000 HU per height; up it widens them about the middle of the opacity's rise, fourfold
    /// per height.
    void drag(QPointF inHeights, bool moving);
    /// Adds a bell to the opacity at the tissue's HU, as high as the maximum of the opacity. One step to undo.
    void addBell(const pdr::TissueBehind& tissue);

  private:
    Document& document_;
    std::optional<TransferFunction> beforeDrag_;
};

}  // namespace pdr::app
