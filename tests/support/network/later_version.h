#pragma once
/// A proxy that lets the programs at both ends of a plain connection appear as later versions: every message gets an
/// unknown field and is followed by a message of an unknown type.

#include <QTcpServer>
#include <QTcpSocket>
#include <algorithm>
#include <cstring>
#include <optional>

#include "app/wire/frame_header.h"
#include "tests/support/network/frame_places.h"

namespace pdr::test {

class LaterVersion {
  public:
    /// Relays between its own port() and the port of a server on this machine.
    explicit LaterVersion(quint16 server) {
        if (!listens_.listen(QHostAddress::LocalHost))
            qFatal("no port is free");
        QObject::connect(&listens_, &QTcpServer::newConnection, &listens_, [this, server] {
            client_ = listens_.nextPendingConnection();
            server_.connectToHost(QHostAddress::LocalHost, server);
            relay(*client_, server_, toServer_);
            relay(server_, *client_, toClient_);
        });
    }
    quint16 port() const { return listens_.serverPort(); }
    /// Returns the number of messages that were relayed: the smaller one of both directions.
    int messages() const { return std::min(toServer_.messages, toClient_.messages); }

  private:
    struct Way {
        QByteArray waits;
        int messages = 0;
    };

    static void relay(QTcpSocket& from, QTcpSocket& to, Way& way) {
        QObject::connect(&from, &QTcpSocket::readyRead, &to, [&from, &to, &way] {
            way.waits += from.readAll();
            while (const std::optional<QByteArray> message = next(way))
                to.write(*message);
        });
        QObject::connect(&from, &QTcpSocket::disconnected, &to, [&to] { to.disconnectFromHost(); });
    }
    static std::optional<QByteArray> next(Way& way) {
        if (way.waits.size() < qsizetype(wire::kHeaderBytes))
            return std::nullopt;
        std::uint32_t mapBytes;
        std::uint64_t payloadBytes;
        std::memcpy(&mapBytes, way.waits.constData() + kMapBytesAt, sizeof mapBytes);
        std::memcpy(&payloadBytes, way.waits.constData() + kPayloadBytesAt, sizeof payloadBytes);
        const qsizetype size = qsizetype(wire::kHeaderBytes + mapBytes + payloadBytes);
        if (way.waits.size() < size)
            return std::nullopt;
        QByteArray message = way.waits.first(size);
        way.waits.remove(0, size);
        ++way.messages;
        const QByteArray field("\x19\x03\xe8\x82\x01\x63new", 9);  // 1000: [1, "new"]
        const qsizetype end = qsizetype(wire::kHeaderBytes + mapBytes) - 1;
        if (message[end] != char(0xff))
            qFatal("a map does not end where it should");
        message.insert(end, field);
        mapBytes += std::uint32_t(field.size());
        std::memcpy(message.data() + kMapBytesAt, &mapBytes, sizeof mapBytes);
        std::memset(message.data() + kChecksumAt, 0, sizeof(std::uint64_t));
        return message + unknown();
    }
    static QByteArray unknown() {
        const auto header = wire::bytesOf({.type = wire::kFirstCritical - 1, .mapBytes = 100, .payloadBytes = 900});
        return QByteArray(reinterpret_cast<const char*>(header.data()), header.size()) + QByteArray(1000, 'x');
    }

    QTcpServer listens_;
    QTcpSocket server_;
    QTcpSocket* client_ = nullptr;
    Way toServer_, toClient_;
};

}  // namespace pdr::test
