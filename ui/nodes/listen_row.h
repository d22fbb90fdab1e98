#pragma once
/// Whether nodes may dial in, on which port, and with whose certificates all of them are spoken to. Setters are silent.

#include <QCheckBox>
#include <QPushButton>
#include <QSpinBox>
#include <QToolButton>
#include <QWidget>
#include <optional>

namespace pdr::ui {

class ListenRow : public QWidget {
    Q_OBJECT

  public:
    explicit ListenRow(QWidget* parent = nullptr);

    /// None: nobody may dial in; the port stays as it is.
    void setListening(std::optional<quint16> port);
    /// Empty: there are none.
    void setBundle(const QString& folder);

  signals:
    void listenRequested(const std::optional<quint16>& port);
    /// A folder with certificates; empty: none are to be used.
    void bundleRequested(const QString& folder);

  private:
    void listen();
    void chooseFolder();

    QCheckBox listens_;
    QSpinBox port_;
    QPushButton certificates_;
    QToolButton without_;
    QString bundle_;
};

}  // namespace pdr::ui
