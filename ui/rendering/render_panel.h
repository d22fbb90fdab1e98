#pragma once
/// The panel for how the image is rendered: on which device, how often it is refreshed, and, collapsed at first, the
/// methods of Exposure Render for comparison. Setters emit no signals.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>

#include "render/scene/model.h"
#include "render/scene/schedule.h"
#include "render/timing/frame_budget.h"

namespace pdr::ui {

class RenderPanel : public QWidget {
    Q_OBJECT

  public:
    explicit RenderPanel(QWidget* parent = nullptr);

    /// Sets the devices. `texts`: what the user reads for each of `names`.
    void setDevices(const QStringList& names, const QStringList& texts);
    void setDevice(const QString& name);
    void setPace(const FrameBudget& pace);
    void setSchedule(const Schedule& schedule);
    void setEstimator(Estimator estimator);
    FrameBudget pace() const;
    Schedule schedule() const;

    QSize sizeHint() const override { return {240, QWidget::sizeHint().height()}; }

  signals:
    void deviceChosen(const QString& name);
    void paceChosen(const pdr::FrameBudget& pace);
    void scheduleChosen(const pdr::Schedule& schedule);
    void estimatorChosen(pdr::Estimator estimator);

  private:
    void describeControls();
    void connectControls();
    QWidget* comparison();
    void enableWhatCounts();

    QComboBox device_;
    QCheckBox automatic_;
    QDoubleSpinBox framesPerSecond_;
    QSpinBox iterations_;
    QToolButton expert_;
    QComboBox schedule_;
    QCheckBox filter_;
    QComboBox estimator_;
};

}  // namespace pdr::ui
