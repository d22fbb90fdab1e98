#pragma once
/// Measurements on slices and in the image: drawing and moving them, and the list of all.

#include <array>
#include <optional>

#include "app/presenters/image_marks.h"
#include "app/presenters/mark_pen.h"
#include "app/presenters/mark_rows.h"
#include "app/presenters/presenter.h"
#include "ui/measure/marks_layer.h"
#include "ui/measure/marks_panel.h"
#include "ui/slices/slice_view.h"

namespace pdr::app {

class MarksPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `slices` shows the views in which is measured, `crosshair` knows what clicks on the image find, and `scenes` is
    /// shared with other look-ups; all must outlive this object.
    MarksPresenter(const Workspace& workspace, SlicesPresenter& slices, CrosshairPresenter& crosshair,
                   PlaceScenes& scenes);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    ui::MarksPanel& panel() { return *panel_; }
    /// The measurements in the image.
    ui::MarksLayer& inImage() { return inImage_.layer(); }

  private:
    void connectSlice(AnatomicalPlane axis, ui::SliceView& view);
    void connectSelection(ui::MarksLayer& layer);
    void connectPanel();
    void drag(const SlicePlane& plane, std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving);
    void moveInImage(std::uint64_t id, int index, const PickedPlace& picked);
    void add(Measurement measurement);
    void askForName(std::uint64_t id);
    void rename(std::uint64_t id, const QString& name);
    void remove(std::uint64_t id);
    void select(std::uint64_t id);
    void show();
    void showProfile();

    ui::MarksPanel* panel_;
    MarkPen pen_;
    std::array<ui::MarksLayer, 3> layers_{ui::MarksLayer(true), ui::MarksLayer(true), ui::MarksLayer(true)};
    ImageMarks inImage_;
    MarkRows rows_;
    std::uint64_t selected_ = 0;  ///< 0: none
    std::uint64_t moving_ = 0;    ///< whose place is being dragged; 0: none
};

}  // namespace pdr::app
