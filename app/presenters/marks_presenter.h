#pragma once
/// Measurements on slices and in the image: drawing and moving them, and the list of all.

#include <array>
#include <optional>

#include "app/presenters/image_marks.h"
#include "app/presenters/mark_rows.h"
#include "app/presenters/mark_tools.h"
#include "app/presenters/presenter.h"
#include "ui/measure/marks_layer.h"
#include "ui/measure/marks_panel.h"
#include "ui/slices/slice_view.h"

namespace pdr::app {

class SlicesPresenter;
class CrosshairPresenter;

class MarksPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `slices` shows the views in which is measured, `crosshair` knows what clicks on the image find, and `scenes` is
    /// shared with other look-ups; all must outlive this object.
    MarksPresenter(const Workspace& workspace, SlicesPresenter& slices, const CrosshairPresenter& crosshair,
                   PlaceScenes& scenes);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    ui::MarksPanel& panel() { return *panel_; }
    /// The measurements in the image.
    ui::MarksLayer& inImage() { return inImage_.layer(); }

  private:
    void connectLayer(AnatomicalPlane plane);
    void connectChoices(ui::MarksLayer& layer);
    void connectPanel();
    void draw(std::optional<MeasureKind> kind);
    void placeOn(const SlicePlane& plane, dvec3 placeMm, bool free);
    void place(const measure::Place& place);
    void takeBack();
    void finish();
    bool mayClose() const;
    bool isInScan(dvec3 placeMm) const;
    void drag(const SlicePlane& plane, std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving);
    void moveInImage(std::uint64_t id, int index, const PickedPlace& picked);
    void add(Measurement measurement);
    void askForName(std::uint64_t id);
    void rename(std::uint64_t id, const QString& name);
    void remove(std::uint64_t id);
    void select(std::uint64_t id);
    void show();
    void showProfile();
    void showDrawn();

    SlicesPresenter& slices_;
    ui::MarksPanel* panel_;
    MarkTools* tools_;
    std::array<ui::MarksLayer, 3> layers_{ui::MarksLayer(true), ui::MarksLayer(true), ui::MarksLayer(true)};
    ImageMarks inImage_;
    MarkRows rows_;
    std::optional<MeasureKind> drawing_;  ///< what is being drawn; none: nothing
    std::vector<measure::Place> drawn_;   ///< the places that it has so far
    dvec3 drawnAt_{0};                    ///< where the crosshair was when the last of them was set
    dvec3 drawnNormal_{0};                ///< unit normal of the slice on which the first of them lies
    std::uint64_t selected_ = 0;          ///< 0: none
    std::uint64_t moving_ = 0;            ///< whose place is being dragged; 0: none
};

}  // namespace pdr::app
