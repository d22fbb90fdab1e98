#pragma once
/// Somebody who has connected and is not known yet. Costs a socket, and nothing of TLS, until it is let in.

#include <QTcpSocket>
#include <QTimer>
#include <chrono>

#include "app/remote/tls.h"

namespace pdr::remote {

class Guest : public QObject {
    Q_OBJECT

  public:
    /// `descriptor`: of the accepted connection. `handshake`: from now until it has to be known.
    Guest(qintptr descriptor, const Identity& identity, std::chrono::milliseconds handshake, QObject* parent);

    /// There is something to read. Plain TCP: always, since there the side that listens may have to speak first.
    bool hasSpoken() const;
    /// Begins the handshake; nothing is emitted before this has returned.
    void letIn();
    /// Once known. The caller owns it.
    QTcpSocket* takeSocket();

    QString host() const { return host_; }
    QString name() const { return name_; }

  signals:
    void spoke();
    /// It has shown that it is the other role's.
    void known();
    /// Not before it was known, and never after. Once.
    void gone(const QString& reason);

  private:
    void begin();
    void check();
    void leave(const QString& reason);

    Identity identity_;
    QTcpSocket* socket_;
    QTimer patience_;
    QString host_, name_;
    QString refusal_;  ///< what TLS has against its certificate
};

}  // namespace pdr::remote
