#pragma once
/// The line below the picture: how good it is, and how far a long step has come. Setters are silent.

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
    /// Below what the text means, in its tool tip.
    void setDetails(const QString& details);
    /// A remark on the right that goes away by itself.
    void showForAWhile(const QString& remark);
    /// Shows `step` and how far it is, [0, 1], with a button to cancel it.
    void setProgress(double fraction, const QString& step);
    void endProgress();

  signals:
    void cancelRequested();
    /// The text was clicked.
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
