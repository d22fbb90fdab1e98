#pragma once
/// An accepted connection before and during its TLS handshake. Costs a socket only until letIn().

#include <QTcpSocket>
#include <QTimer>
#include <chrono>

#include "app/remote/tls.h"

namespace pdr::remote {

class Guest : public QObject {
    Q_OBJECT

  public:
    /// `descriptor`: of the accepted connection. `handshake`: time limit, from now.
    Guest(qintptr descriptor, const Identity& identity, std::chrono::milliseconds handshake, QObject* parent);

    /// There is something to read. Plain TCP: always, since the listening side may have to speak first.
    bool hasSpoken() const;
    /// Begins the handshake; nothing is emitted before this has returned.
    void letIn();
    /// After known(). Ownership passes to the caller.
    QTcpSocket* takeSocket();

    QString host() const { return host_; }
    QString name() const { return name_; }

  signals:
    void spoke();
    /// The handshake has succeeded: the peer has the other role.
    void known();
    /// The handshake has failed, or the peer has disconnected before its end. Once, and never after known().
    void gone(const QString& reason);

  private:
    void begin();
    void check();
    void leave(const QString& reason);

    Identity identity_;
    QTcpSocket* socket_;
    QTimer patience_;
    QString host_, name_;
    QString refusal_;  ///< why TLS rejects its certificate
};

}  // namespace pdr::remote
