#pragma once
/// A field for the address of a node that is to render along. What is no address is not asked for: a sentence says what
/// is wrong with it. Setters are silent.

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QWidget>

namespace pdr::ui {

class AddressRow : public QWidget {
    Q_OBJECT

  public:
    explicit AddressRow(QWidget* parent = nullptr);

  signals:
    /// "gpu-07:4743"
    void addRequested(const QString& address);
    /// What is wrong with what was typed: a sentence; empty: nothing is any more.
    void problemFound(const QString& sentence);

  private:
    void add();

    QLineEdit field_;
    QPushButton add_;
};

}  // namespace pdr::ui
