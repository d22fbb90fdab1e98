#pragma once
/// Three slices beside the image, which agree on one place of the patient.

#include <QTimer>
#include <array>
#include <optional>

#include "app/jobs/slice_job.h"
#include "app/presenters/arrival_watch.h"
#include "app/presenters/presenter.h"
#include "app/presenters/slice_framing.h"
#include "ui/slices/slice_view.h"

namespace pdr::app {

class SlicesPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit SlicesPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void releaseVolume() override;
    /// Shows the slices beside the image, unless they are shown already.
    void showSlices();
    /// Gives a slice the keyboard, unless one has it already.
    void focusOne();
    /// Shows the slices of the scan that is open with parts in colours.
    void setTint(SliceTint tint);
    /// The menu of the slices.
    QMenu& menu() { return *menu_; }
    ui::SliceView& view(AnatomicalPlane plane) { return *slices_[std::size_t(plane)].view; }

  private:
    /// One slice: its view, the job that computes it, and the stack that it is one of.
    struct Slice {
        ui::SliceView* view = nullptr;  ///< owned by the window
        SliceJob job;
        std::optional<SliceStack> stack;  ///< none without a scan
    };

    void fillMenu(QMenu& menu);
    void addWindowMenu(QMenu& menu);
    void setWindow(const GreyWindow& shown);
    void openMenu(Slice& slice, QPoint place);
    void fit(const Slice& slice);
    void connectSlice(Slice& slice);
    void setLayout(ViewLayout layout);
    void showLayout(ViewLayout layout);
    void setScan(SlicedScan scan);
    void showArrived();
    bool request(Slice& slice, bool moving = false);
    void requestAll(bool moving);
    void copy(Slice& slice);
    void show(Slice& slice, const QImage& grey, const SlicePlane& plane, const GreyWindow& window);
    void showPointed(Slice& slice, const std::optional<dvec3>& placeMm);
    void chooseWindow(char key);
    void dragWindow(double wider, double brighter);
    QStringList textsOf(const Slice& slice, const SlicePlane& plane, const GreyWindow& window) const;
    SliceFraming& framingOf(Navigation& navigation, const Slice& slice) const;
    std::optional<SlicePlane> planeOf(const Slice& slice) const;

    QMenu* menu_ = nullptr;              ///< owned by the window
    QMenu* windows_ = nullptr;           ///< the menu of windows
    QAction* offerWindows_ = nullptr;    ///< opens the menu of windows
    std::array<Slice, 3> slices_;        ///< in the order of kAnatomicalPlanes
    std::array<QAction*, 3> layouts_{};  ///< in the order of kViewLayouts
    SlicedScan scan_;
    SliceTint tint_;
    QTimer atRest_;  ///< runs while something moves: until nothing has for a while
    std::optional<ArrivalWatch> arrival_;
};

}  // namespace pdr::app
