#pragma once
/// The layer that shows the crosshair of the slices in the image: three short lines through the place, across the
/// slices that contain it. Setters emit no signals.

#include <QString>
#include <optional>

#include "ui/view/view_tool.h"

namespace pdr::ui {

/// What of the image lies in front of a place.
enum class InFront {
    unknown,  ///< not computed yet
    little,   ///< at least half of the light from the place reaches the eye
    tissue,   ///< less than half does
    cut       ///< nothing: the place itself is cut away or hidden
};

class CrosshairLayer : public ViewTool {
    Q_OBJECT

  public:
    using ViewTool::ViewTool;

    /// Sets the place, in the patient (LPS) [mm]; none: nothing is shown. What lies in front of it is not known then.
    void setPlace(const std::optional<dvec3>& placeMm);
    const std::optional<dvec3>& place() const { return placeMm_; }
    /// Sets what lies in front of the place, and a text that is painted beside it; empty: none.
    void setInFront(InFront inFront, const QString& text);
    InFront inFront() const { return inFront_; }

    void paint(QPainter& painter, const ImagePlace& image) const override;

  private:
    std::optional<dvec3> placeMm_;
    InFront inFront_ = InFront::unknown;
    QString text_;
};

}  // namespace pdr::ui
