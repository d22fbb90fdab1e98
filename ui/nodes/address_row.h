#pragma once
/// A field for the address of a render node to add. An invalid address is not requested; a sentence explains what is
/// wrong with it. Setters emit no signals.

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
    /// Requests to add the node at `address`: "gpu-07:4743".
    void addRequested(const QString& address);
    /// Reports what is wrong with the typed address: a sentence; empty: nothing is any more.
    void problemFound(const QString& sentence);

  private:
    void add();

    QLineEdit field_;
    QPushButton add_;
};

}  // namespace pdr::ui
