#pragma once
/// The image's accuracy and when rendering stops: status bar, accuracy panel, target, pause and battery.

#include "app/presenters/presenter.h"
#include "app/rendering/battery_rest.h"
#include "ui/accuracy/accuracy_panel.h"

namespace pdr::app {

class AccuracyPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `powerSupplies`: see onBattery(); empty: rendering does not depend on the power supply.
    AccuracyPresenter(const Workspace& workspace, std::filesystem::path powerSupplies);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void clearImage() override;
    /// Marks what happened to render nodes on the plot of the error.
    void setEvents(const ui::PlotEvents& events) { panel_->plot().setEvents(events); }

  private:
    void connectTarget();
    void connectPause();
    void showStatus();
    void showStop(const StopRule& rule);
    ui::Accuracy accuracyOf(const Frame& frame) const;

    ui::AccuracyPanel* panel_;
    BatteryRest battery_;
};

}  // namespace pdr::app
