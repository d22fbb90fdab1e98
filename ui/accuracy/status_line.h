#pragma once
/// The line below the image that shows its accuracy and the progress of a long step. Setters emit no signals.

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

#include "ui/widgets/elided_label.h"

namespace pdr::ui {

class StatusLine : public QWidget {
    Q_OBJECT

  public:
    explicit StatusLine(QWidget* parent = nullptr);

    void setText(const QString& text);
    QString text() const { return text_.text(); }
    /// Sets the last paragraph of the text's tool tip, below the explanation of the text.
    void setDetails(const QString& details);
    /// Shows a remark on the right that disappears after 6 s.
    void showForAWhile(const QString& remark);
    /// Shows `step` and its progress in [0, 1], with a button to cancel it.
    void setProgress(double fraction, const QString& step);
    void endProgress();

  signals:
    void cancelRequested();
    /// Emitted when the user clicks the text.
    void textClicked();

  protected:
    void mouseReleaseEvent(QMouseEvent* event) override;

  private:
    void showTip();

    ElidedLabel text_;
    QString details_;
    ElidedLabel step_;
    QTimer remarkTimer_;
    QProgressBar bar_;
    QPushButton cancel_;
};

}  // namespace pdr::ui
