#pragma once
/// A line of text that may be narrower than it would like: it is cut with dots, and the tool tip has all of it.

#include <QLabel>

namespace pdr::ui {

class ElidedLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ElidedLabel(QWidget* parent = nullptr);

    void setLine(const QString& text);

    QSize minimumSizeHint() const override { return {0, QLabel::minimumSizeHint().height()}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace pdr::ui
