#pragma once
/// How good the picture is, in full: how its error falls, what is noise and what is not, what went wrong with samples,
/// and what it is made by. Setters are silent.

#include <QLabel>

#include "ui/accuracy/error_plot.h"
#include "ui/widgets/stop_row.h"

namespace pdr::ui {

class AccuracyPanel : public QWidget {
    Q_OBJECT

  public:
    explicit AccuracyPanel(QWidget* parent = nullptr);

    ErrorPlot& plot() { return *plot_; }
    StopRow& stop() { return *stop_; }

    /// `rule`: when rendering holds.
    void setAccuracy(const Accuracy& accuracy, const StopRule& rule);
    /// Sentences on what is not noise.
    void setBias(const QStringList& remarks);
    /// What the picture is made by.
    void setMaking(const QString& making);
    void clear();

  private:
    ErrorPlot* plot_;
    StopRow* stop_;
    QLabel* comesFirst_;
    QLabel* noise_;
    QLabel* bias_;
    QLabel* health_;
    QLabel* making_;
};

}  // namespace pdr::ui
