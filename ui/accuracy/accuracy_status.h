#pragma once
/// The content of the window's status bar: a sentence on the image's accuracy, a strip that shows what more accuracy
/// costs, and remarks in a small font. Setters emit no signals.

#include "ui/accuracy/accuracy_strip.h"
#include "ui/accuracy/status_line.h"
#include "ui/widgets/elided_label.h"

namespace pdr::ui {

class AccuracyStatus : public QWidget {
    Q_OBJECT

  public:
    explicit AccuracyStatus(QWidget* parent = nullptr);

    StatusLine& status() { return *status_; }
    AccuracyStrip& strip() { return *strip_; }

    void setAccuracy(const Accuracy& accuracy);
    /// Clears everything but a progress report and the target.
    void clear();
    /// Sets the text on how the image is rendered, shown in the sentence's tool tip.
    void setMaking(const QString& making);
    /// Sets the remarks on the image. A line without room for all of them ends in dots; the tool tip shows them in
    /// full.
    void setRemarks(const QStringList& remarks);
    /// Sets the remark at the right end: the limit that rendering cannot improve, e.g. the scan's resolution.
    void setLimit(const QString& limit);

  private:
    StatusLine* status_;
    AccuracyStrip* strip_;
    ElidedLabel* remarks_;
    ElidedLabel* limit_;
};

}  // namespace pdr::ui
