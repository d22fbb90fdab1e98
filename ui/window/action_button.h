#pragma once
/// The button of an action, with an icon, whose tool tip ends with the action's key.

#include <QAction>
#include <QToolButton>

namespace pdr::ui {

class ActionButton : public QToolButton {
  public:
    /// Shows `action`, which must outlive this object, by the icon of its object name.
    explicit ActionButton(QAction& action, QWidget* parent = nullptr);

  protected:
    void actionEvent(QActionEvent* event) override;

  private:
    void describe();

    QAction& action_;
};

}  // namespace pdr::ui
