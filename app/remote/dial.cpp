#include "app/remote/dial.h"

#include <QHostAddress>
#include <QNetworkProxy>
#include <QSslSocket>

namespace pdr::remote {

Dial::Dial(const Address& address, const Identity& identity, const DialLimits& limits, QObject* parent)
    : QObject(parent), address_(address), identity_(identity), limits_(limits) {
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this, [this] { fail(phrase("no answer"), ErrorKind::failed); });
    patience_.start(limits.connecting);
    QTimer::singleShot(0, this, &Dial::begin);
}

void Dial::begin() {
    if (identity_.tls)
        beginTls();
    else
        socket_ = new QTcpSocket(this);
    connect(socket_, &QTcpSocket::errorOccurred, this,
            [this] { fail(socket_->errorString().toStdString(), ErrorKind::failed); });
    socket_->setProxy(QNetworkProxy::NoProxy);
    if (auto* tls = qobject_cast<QSslSocket*>(socket_)) {
        tls->connectToHostEncrypted(address_.host, address_.port, nameIn(other(identity_.role)));
    } else {
        connect(socket_, &QTcpSocket::connected, this, &Dial::arrived);
        socket_->connectToHost(address_.host, address_.port);
    }
}

void Dial::beginTls() {
    auto* tls = new QSslSocket(this);
    socket_ = tls;
    tls->setSslConfiguration(*identity_.tls);
    connect(tls, &QSslSocket::encrypted, this, &Dial::arrived);
    connect(tls, &QSslSocket::sslErrors, this, [this, tls](const QList<QSslError>& errors) {
        fail(whyUnbelieved(errors, tls->peerCertificate(), identity_), ErrorKind::refused);
    });
}

void Dial::arrived() {
    const auto* tls = qobject_cast<QSslSocket*>(socket_);
    if (const Text why = tls ? whyNot(tls->peerCertificate(), identity_) : Text(); !why.empty())
        return fail(why, ErrorKind::refused);
    if (!tls && !socket_->peerAddress().isLoopback())
        return fail(phrase("without certificates only this machine itself may be dialled"), ErrorKind::refused);
    patience_.stop();
    socket_->disconnect(this);
    emit connected(new Channel(socket_, identity_.role, limits_.channel, this));
}

/// Reports a failure. Emits later, not within the socket's signal: the socket may still be busy with what failed.
void Dial::fail(const Text& what, ErrorKind kind) {
    patience_.stop();
    if (socket_)
        socket_->disconnect(this);
    const Error error{phrase("there is no connection: %1", what), address_.text().toStdString(), "", kind};
    QTimer::singleShot(0, this, [this, error] {
        if (socket_)
            socket_->abort();  // the other side may be content with this one
        emit failed(error);
    });
}

}  // namespace pdr::remote
