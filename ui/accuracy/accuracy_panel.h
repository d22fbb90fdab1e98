#pragma once
/// A panel with all that is known about the image's accuracy: how its error falls, noise and bias, invalid samples, and
/// device and settings of the rendering. Setters emit no signals.

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

    /// Sets the accuracy to show. `rule`: when rendering stops.
    void setAccuracy(const Accuracy& accuracy, const StopRule& rule);
    /// Sets the sentences on errors other than noise.
    void setBias(const QStringList& remarks);
    /// Sets the text on how the image is rendered, e.g. device and samples.
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
