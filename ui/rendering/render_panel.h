#pragma once
/// How the picture is computed: on which device, how often it is shown anew, and, folded away, the ways of Exposure
/// Render to compare with. Setters are silent.

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

    /// `texts` are what the user reads for each name.
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
