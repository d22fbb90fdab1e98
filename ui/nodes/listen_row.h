#pragma once
/// The controls for whether nodes may dial in, on which port, and which certificates all connections use. Setters emit
/// no signals.

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

    /// Sets the port on which nodes may dial in. None: none may; the field keeps its port.
    void setListening(std::optional<quint16> port);
    /// Sets the folder with certificates. Empty: there are none.
    void setBundle(const QString& folder);

  signals:
    void listenRequested(const std::optional<quint16>& port);
    /// Requests to use the certificates in `folder`. Empty: none.
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
