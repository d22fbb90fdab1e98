#pragma once
/// A channel, and a socket at its other end that does what a test says.

#include <QTcpServer>

#include "app/wire/frame_reader.h"
#include "tests/app/remote/meeting.h"

namespace pdr::test {

/// The channel of a coordinator, and the socket at its other end.
struct Rig {
    explicit Rig(const remote::ChannelLimits& limits = Meeting::patientLimits().channel) {
        QTcpServer server;
        if (!server.listen(QHostAddress::LocalHost))
            qFatal("no port is free");
        socket.connectToHost(server.serverAddress(), server.serverPort());
        if (!server.waitForNewConnection(kPatience) || !socket.waitForConnected(kPatience))
            qFatal("this machine does not talk to itself");
        QTcpSocket* accepted = server.nextPendingConnection();
        accepted->setParent(nullptr);
        channel = std::make_unique<remote::Channel>(accepted, remote::Role::coordinator, limits);
        QObject::connect(channel.get(), &remote::Channel::received, channel.get(),
                         [this](const wire::Message& message) { received.push_back(message); });
        QObject::connect(channel.get(), &remote::Channel::closed, channel.get(), [this](const Text& why) {
            ++ends;
            reason = QString::fromStdString(why);
        });
    }

    void say(const wire::Message& message) { say(wire::inOnePiece(wire::encode(message))); }
    void say(const wire::Bytes& bytes) {
        socket.write(reinterpret_cast<const char*>(bytes.data()), qint64(bytes.size()));
    }

    QTcpSocket socket;
    std::unique_ptr<remote::Channel> channel;
    std::vector<wire::Message> received;
    int ends = 0;
    QString reason;
};

/// What a channel sends to a node.
struct Reading {
    explicit Reading(QTcpSocket& socket) : reader(remote::Role::node) {
        reader.setAdmitted(true);
        QObject::connect(&socket, &QTcpSocket::readyRead, &socket, [this, &socket] { take(socket.readAll()); });
        take(socket.readAll());
    }
    void take(const QByteArray& bytes) {
        auto rest = std::as_bytes(std::span(bytes.constData(), std::size_t(bytes.size())));
        while (auto message = reader.next(rest)) {
            if (!*message)
                return;
            messages.push_back(**message);
        }
        isSenseless = true;
    }
    wire::FrameReader reader;
    std::vector<wire::Message> messages;
    bool isSenseless = false;
};

}  // namespace pdr::test
