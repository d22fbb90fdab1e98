#pragma once
/// The marks of a cut over the image, and the handle under the pointer.

#include <QPainter>
#include <QPolygonF>
#include <optional>
#include <vector>

#include "render/scene/edit/cut_handles.h"

namespace pdr::ui {

class CutMarks {
  public:
    CutMarks() = default;
    /// Computes the marks. `area`: the part of the widget that the image takes [px].
    CutMarks(const Clip& clip, const Uncut& uncut, const ViewGeometry& view, const QRectF& area);

    /// Returns the handle at `place`: the nearest handle, preferably one on the near side; else a ring; else an edge of
    /// a box that cuts.
    std::optional<CutHandle> at(QPointF place) const;
    /// Returns the place of a handle [px]; none where it is not visible.
    std::optional<QPointF> placeOf(CutHandle handle) const;
    void paint(QPainter& painter, const std::optional<CutHandle>& lit) const;

  private:
    struct Dot {
        CutHandle handle;
        QPointF place;
        bool behind;  ///< on a face turned away from the viewer
    };
    struct Line {
        CutHandle handle;
        QPolygonF points;
        bool holds;  ///< it can be dragged
    };

    void addBox(const Clip& clip, const Uncut& uncut);
    void addPlane(const ClipPlane& plane, int number, const Uncut& uncut);
    void addDot(CutHandle handle, dvec3 placeMm, dvec3 outwards = dvec3(0));
    void addLine(CutHandle handle, const std::vector<dvec3>& placesMm, bool holds);
    QPointF inPixels(dvec2 point) const;

    std::optional<ViewGeometry> view_;
    QRectF area_;
    std::vector<Dot> dots_;
    std::vector<Line> lines_;
};

}  // namespace pdr::ui
