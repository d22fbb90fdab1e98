#pragma once
/// Measurements on slices: drawing and moving them, their values, and the list of all.

#include <array>
#include <optional>

#include "app/presenters/presenter.h"
#include "ui/measure/marks_layer.h"
#include "ui/measure/marks_panel.h"
#include "ui/slices/slice_view.h"

namespace pdr::app {

class SlicesPresenter;

class MarksPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `slices` shows the views in which is measured, and must outlive this object.
    MarksPresenter(const Workspace& workspace, SlicesPresenter& slices);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    ui::MarksPanel& panel() { return *panel_; }

  private:
    void fillMenu(QMenu& menu);
    void connectLayer(AnatomicalPlane plane);
    void connectPanel();
    void draw(std::optional<MeasureKind> kind);
    void place(const SlicePlane& plane, dvec3 placeMm, bool free);
    void drag(const SlicePlane& plane, std::uint64_t id, int index, dvec3 placeMm, bool free, bool moving);
    measure::Place placeAt(const SlicePlane& plane, dvec3 placeMm, bool free) const;
    void add(Measurement measurement);
    void rename(std::uint64_t id, const QString& name);
    void remove(std::uint64_t id);
    void select(std::uint64_t id);
    void show();
    void showDrawn();

    SlicesPresenter& slices_;
    ui::MarksPanel* panel_;
    std::array<ui::MarksLayer, 3> layers_{ui::MarksLayer(true), ui::MarksLayer(true), ui::MarksLayer(true)};
    ui::MarksLayer inImage_{false};
    QAction *distance_ = nullptr, *angle_ = nullptr;
    std::optional<MeasureKind> drawing_;  ///< what is being drawn; none: nothing
    std::vector<measure::Place> drawn_;   ///< the places that it has so far
    std::uint64_t selected_ = 0;          ///< 0: none
};

}  // namespace pdr::app
