#pragma once
/// A label of one line that may be narrower than its text: the text is cut off with dots, and the tool tip shows all of
/// it.

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
