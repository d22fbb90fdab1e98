#pragma once
/// How the picture is computed: on which device, how often it is shown anew, and, folded away, the ways of Exposure
/// Render to compare with. Setters are silent.

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>

#include "render/scene/scene.h"

namespace pdr::ui {

/// How many iterations a displayed picture gets.
struct FrameBudgetChoice {
    bool automatic = true;
    int iterations = 1;           ///< by hand; [1, 1000]
    double framesPerSecond = 10;  ///< automatic; [0.1, 60]
    bool operator==(const FrameBudgetChoice&) const = default;
};

/// How iterations become pictures.
struct ScheduleChoice {
    enum class Way { ours, k0, k1 };  ///< K0 and K1: Exposure Render's, as it is and without redundant uploads
    Way way = Way::ours;
    bool filter = true;  ///< of K0 and K1: each iteration is blurred
    bool operator==(const ScheduleChoice&) const = default;
};

class RenderPanel : public QWidget {
    Q_OBJECT

  public:
    explicit RenderPanel(QWidget* parent = nullptr);

    /// `texts` are what the user reads for each name.
    void setDevices(const QStringList& names, const QStringList& texts);
    void setDevice(const QString& name);
    void setPace(const FrameBudgetChoice& pace);
    void setSchedule(const ScheduleChoice& schedule);
    void setEstimator(Estimator estimator);
    FrameBudgetChoice pace() const;
    ScheduleChoice schedule() const;

    QSize sizeHint() const override { return {240, QWidget::sizeHint().height()}; }

  signals:
    void deviceChosen(const QString& name);
    void paceChosen(const pdr::ui::FrameBudgetChoice& pace);
    void scheduleChosen(const pdr::ui::ScheduleChoice& schedule);
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
