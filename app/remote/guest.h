#pragma once
/// An accepted connection before and during its TLS handshake. Until letIn() it costs no more than a socket.

#include <QTcpSocket>
#include <QTimer>
#include <chrono>

#include "app/remote/tls.h"

namespace pdr::remote {

class Guest : public QObject {
    Q_OBJECT

  public:
    /// `descriptor`: socket of the accepted connection. `handshake`: time limit, from now.
    Guest(qintptr descriptor, const Identity& identity, std::chrono::milliseconds handshake, QObject* parent);

    /// Whether there is something to read. Always true for plain TCP, where the listening side may have to send first.
    bool hasSpoken() const;
    /// Begins the handshake. Nothing is emitted before this call has returned.
    void letIn();
    /// Passes ownership of the socket to the caller. Call it after known().
    QTcpSocket* takeSocket();

    QString host() const { return host_; }
    QString name() const { return name_; }

  signals:
    void spoke();
    /// The handshake has succeeded: the peer has the other role.
    void known();
    /// The handshake has failed, or the peer has disconnected before its end. Emitted once, and never after known().
    void gone(const QString& reason);

  private:
    void begin();
    void check();
    void leave(const QString& reason);

    Identity identity_;
    QTcpSocket* socket_;
    QTimer patience_;
    QString host_, name_;
    QString refusal_;  ///< why TLS rejects the peer's certificate
};

}  // namespace pdr::remote
