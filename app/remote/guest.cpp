#include "app/remote/guest.h"

#include <QHostAddress>
#include <QSslSocket>

#include "app/remote/tcp_options.h"

namespace pdr::remote {
namespace {

/// Returns the peer's address. An IPv4 address reads the same whether the socket is for both families or not.
QString hostOf(const QTcpSocket& socket) {
    bool isIpv4 = false;
    const quint32 ipv4 = socket.peerAddress().toIPv4Address(&isIpv4);
    return isIpv4 ? QHostAddress(ipv4).toString() : socket.peerAddress().toString();
}

}  // namespace

Guest::Guest(qintptr descriptor, const Identity& identity, std::chrono::milliseconds handshake, QObject* parent)
    : QObject(parent), identity_(identity), socket_(identity.tls ? new QSslSocket(this) : new QTcpSocket(this)) {
    socket_->setSocketDescriptor(descriptor);
    setOptions(*socket_, handshake);
    host_ = hostOf(*socket_);
    name_ = Address{host_, socket_->peerPort()}.text();
    connect(socket_, &QTcpSocket::errorOccurred, this, [this] { leave(socket_->errorString()); });
    connect(socket_, &QTcpSocket::disconnected, this, [this] { leave("it went"); });
    if (auto* tls = qobject_cast<QSslSocket*>(socket_)) {
        connect(socket_, &QTcpSocket::readyRead, this, &Guest::spoke);
        connect(tls, &QSslSocket::encrypted, this, &Guest::check);
        connect(tls, &QSslSocket::sslErrors, this, [this, tls](const QList<QSslError>& errors) {
            refusal_ = QString::fromStdString(whyUnbelieved(errors, tls->peerCertificate(), identity_));
        });
    }
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this, [this] { leave("it took too long"); });
    patience_.start(handshake);
}

bool Guest::hasSpoken() const {
    return !identity_.tls || socket_->bytesAvailable() > 0;
}

void Guest::letIn() {
    QTimer::singleShot(0, this, &Guest::begin);
}

void Guest::begin() {
    auto* tls = qobject_cast<QSslSocket*>(socket_);
    if (!tls) {
        emit known();
        return;
    }
    disconnect(socket_, &QTcpSocket::readyRead, this, nullptr);
    tls->setSslConfiguration(*identity_.tls);
    tls->startServerEncryption();
}

void Guest::check() {
    const Text why = whyNot(qobject_cast<QSslSocket*>(socket_)->peerCertificate(), identity_);
    if (why.empty())
        emit known();
    else
        leave(QString::fromStdString(why));
}

QTcpSocket* Guest::takeSocket() {
    socket_->disconnect(this);
    patience_.stop();
    socket_->setParent(nullptr);
    return socket_;
}

void Guest::leave(const QString& reason) {
    socket_->disconnect(this);
    patience_.stop();
    socket_->abort();
    emit gone(refusal_.isEmpty() ? reason : refusal_);
}

}  // namespace pdr::remote
