#pragma once
/// The foot of the window: a sentence that says how good the picture is, a strip that says what more costs, and in
/// small letters what else is true. Setters are silent.

#include "ui/accuracy/accuracy_strip.h"
#include "ui/accuracy/status_line.h"
#include "ui/widgets/elided_label.h"

namespace pdr::ui {

class Foot : public QWidget {
    Q_OBJECT

  public:
    explicit Foot(QWidget* parent = nullptr);

    StatusLine& status() { return *status_; }
    AccuracyStrip& strip() { return *strip_; }

    void setAccuracy(const Accuracy& accuracy);
    /// Empties all of it, but for a long step and the target.
    void clear();
    /// What the picture is made by, in the sentence's tool tip.
    void setMaking(const QString& making);
    /// Sentences that are true of the picture; what has no room ends in dots, and stands in the tool tip.
    void setRemarks(const QStringList& remarks);
    /// What no computing can mend, at the right end.
    void setLimit(const QString& limit);

  private:
    StatusLine* status_;
    AccuracyStrip* strip_;
    ElidedLabel* remarks_;
    ElidedLabel* limit_;
};

}  // namespace pdr::ui
