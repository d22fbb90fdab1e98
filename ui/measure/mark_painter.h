#pragma once
/// Paints marks over a slice or an image: their curves, their handles, and labels that do not cover one another.

#include <QPainter>
#include <optional>

#include "ui/measure/label_places.h"
#include "ui/measure/mark_curves.h"
#include "ui/view/image_place.h"

namespace pdr::ui {

/// How far off a slice a place still counts as lying in it [mm].
inline constexpr double kInSliceMm = 0.6;

/// Which parts of a mark are hidden in the image. Empty: not known.
struct MarkHidden {
    std::vector<bool> places;              ///< those of the mark, in their order
    std::vector<std::vector<bool>> parts;  ///< those of its curves, in their order
    bool operator==(const MarkHidden&) const = default;
};

class MarkPainter {
  public:
    /// `image` must have an image. `slice`: it is a slice; marks off it are dashed, and those far off are left out.
    MarkPainter(QPainter& painter, const ImagePlace& image, bool slice);

    /// Paints a mark without its label. `lit`: index of the handle under the pointer; -1: none.
    void paint(const ShownMark& mark, int lit = -1, const MarkHidden& hidden = {});
    /// Paints the labels of all marks that were painted.
    void paintLabels();

  private:
    void paintCurve(const MarkCurve& curve, const QPen& pen, const std::vector<bool>& hidden);
    void paintHandle(const dvec3& placeMm, bool lit, bool hollow);

    QPainter& painter_;
    const ImagePlace& image_;
    bool slice_;
    std::vector<LabelWish> wishes_;
    std::vector<QString> labels_;
};

}  // namespace pdr::ui
