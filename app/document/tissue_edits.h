#pragma once
/// What the hand does to the tissue's curves, on the panel and on the picture, as edits of the document.

#include <QObject>
#include <QPointF>
#include <optional>

#include "app/document/document.h"
#include "render/prepare/focus.h"

namespace pdr::app {

class TissueEdits : public QObject {
    Q_OBJECT

  public:
    /// `document` outlives it.
    explicit TissueEdits(Document& document) : document_(document) {}

  public slots:
    /// One gesture is one step to undo.
    void setTransferFunction(const pdr::TransferFunction& function, bool moving);
    /// A drag on the picture, from where it began, in fractions of the view's height: to the right shifts all curves up
    /// by 1000 HU a height; up widens them about the middle of the opacity's rise, fourfold a height.
    void drag(QPointF inHeights, bool moving);
    /// A bell at the tissue's HU, as high as the opacity is anywhere: one step to undo.
    void addBell(const pdr::TissueUnder& tissue);

  private:
    Document& document_;
    std::optional<TransferFunction> beforeDrag_;
};

}  // namespace pdr::app
