#pragma once
/// A side that listens and a side that dials it, which introduce themselves as coordinator and node do.

#include <QTemporaryDir>
#include <QTest>
#include <memory>
#include <vector>

#include "app/remote/certificates.h"
#include "app/remote/dial.h"
#include "app/remote/listener.h"
#include "tests/support/patience.h"

namespace pdr::test {

/// Returns the identity of a role, from a bundle that is made once in a program.
inline remote::Identity identityOf(remote::Role role) {
    static const QTemporaryDir folder;
    static const Result<void> made = remote::makeCertificates(folder.filePath("bundle"));
    const auto identity =
        made ? remote::readIdentity(folder.filePath("bundle"), role) : Result<remote::Identity>(made.error());
    if (!identity)
        qFatal("%s", identity.error().text().c_str());
    return *identity;
}

inline remote::Identity plain(remote::Role role) {
    return {role, std::nullopt, {}};
}

/// What one side has seen. The node greets; who is greeted admits the other.
struct Side {
    std::unique_ptr<remote::Channel> channel;
    std::vector<wire::Message> received;
    bool admitted = false;
    int ends = 0;  ///< times it was told that it is over
    QString reason;

    void take(remote::Channel* arrived, remote::Role role) {
        channel.reset(arrived);
        channel->setParent(nullptr);
        QObject::connect(arrived, &remote::Channel::received, arrived, [this, role](const wire::Message& message) {
            received.push_back(message);
            const bool greeted = role == remote::Role::node ? std::holds_alternative<wire::Welcome>(message)
                                                            : std::holds_alternative<wire::Hello>(message);
            if (greeted && !admitted)
                admit(role);
        });
        QObject::connect(arrived, &remote::Channel::closed, arrived,
                         [this](const Text& why) { end(QString::fromStdString(why)); });
        if (role == remote::Role::node)
            channel->send(wire::Hello{.program = "test", .name = "node"});
    }
    void admit(remote::Role role) {
        admitted = true;
        channel->setAdmitted();
        if (role == remote::Role::coordinator)
            channel->send(wire::Welcome{});
    }
    void end(const QString& why) {
        ++ends;
        reason = why;
    }
};

class Meeting {
  public:
    Meeting(const remote::Identity& listens, const remote::Identity& dials,
            const remote::ListenerLimits& limits = patientLimits())
        : listener(listens, limits), dials_(dials), channelLimits_(limits.channel) {
        QObject::connect(&listener, &remote::Listener::connected, &listener,
                         [this, role = listens.role](remote::Channel* channel) { listening.take(channel, role); });
        QObject::connect(&listener, &remote::Listener::turnedAway, &listener,
                         [this](const QString&, const QString& why) { listening.end(why); });
        const auto listened = listener.listen({"127.0.0.1", 0});
        if (!listened)
            qFatal("%s", listened.error().text().c_str());
    }

    /// `port`: another one than the listener's, as a proxy's.
    void begin(quint16 port = 0) {
        const remote::Address address{"127.0.0.1", port ? port : listener.address().port};
        dial = std::make_unique<remote::Dial>(address, dials_,
                                              remote::DialLimits{std::chrono::milliseconds(kPatience), channelLimits_});
        QObject::connect(dial.get(), &remote::Dial::connected, dial.get(),
                         [this](remote::Channel* channel) { dialling.take(channel, dials_.role); });
        QObject::connect(dial.get(), &remote::Dial::failed, dial.get(), [this](const Error& error) {
            failure = error;
            dialling.end(QString::fromStdString(error.text()));
        });
    }
    /// Whether both admitted each other, or both are through with it.
    bool isSettled() const {
        return (listening.admitted && dialling.admitted) || (listening.ends > 0 && dialling.ends > 0);
    }

    /// Returns limits so long that nothing depends on how busy the machine is.
    static remote::ListenerLimits patientLimits() {
        const std::chrono::milliseconds patience(kPatience);
        return {.handshake = patience,
                .channel = {
                    .admission = patience, .farewell = patience, .unheard = patience, .drip = {.window = patience}}};
    }

    remote::Listener listener;
    std::unique_ptr<remote::Dial> dial;
    Side listening, dialling;
    Error failure;

  private:
    remote::Identity dials_;
    remote::ChannelLimits channelLimits_;
};

}  // namespace pdr::test
