#pragma once
/// Draws measurements: the tools that begin one, and the clicks on slices and on the image that set its places.

#include <map>
#include <optional>
#include <vector>

#include "app/presenters/mark_drawing.h"
#include "app/presenters/mark_tools.h"
#include "app/presenters/workspace.h"
#include "ui/measure/marks_layer.h"

namespace pdr::app {

class SlicesPresenter;
class CrosshairPresenter;

class MarkPen : public QObject {
    Q_OBJECT

  public:
    /// Adds its tools to the menu of `slices` and to `panel`. `slices` shows the views in which is measured,
    /// `crosshair` knows what clicks on the image find; all must outlive this object.
    MarkPen(const Workspace& workspace, SlicesPresenter& slices, CrosshairPresenter& crosshair, ui::MarksPanel& panel);

    /// Draws in the view of a slice, over which `layer` lies.
    void addSlice(AnatomicalPlane axis, ui::MarksLayer& layer);
    /// Draws in the image, over which `layer` lies.
    void addImage(ui::MarksLayer& layer);
    /// Ends drawing.
    void stop() { draw(std::nullopt); }
    void showDocument(Changes changes);

  signals:
    /// Reports a measurement that has all its places, and no id yet.
    void drawn(const pdr::app::Measurement& measurement);

  private:
    Document& document() const { return workspace_.document; }
    void add(ui::MarksLayer& layer);
    void draw(std::optional<MeasureKind> kind);
    void placeOn(const ViewedSlice& slice, dvec3 placeMm, bool free);
    void sayWhere();
    void goOn();
    void takeBack();
    void finish();
    void show();

    Workspace workspace_;
    SlicesPresenter& slices_;
    CrosshairPresenter& crosshair_;
    MarkTools tools_;
    std::vector<ui::MarksLayer*> layers_;
    std::map<AnatomicalPlane, ui::MarksLayer*> ofSlices_;
    std::optional<MarkDrawing> drawing_;  ///< what is being drawn; none: nothing
    dvec3 drawnAt_{0};                    ///< where the crosshair was when its last place was set
};

}  // namespace pdr::app
