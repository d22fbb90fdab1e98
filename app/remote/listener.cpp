#include "app/remote/listener.h"

#include <QNetworkProxy>
#include <QTimer>
#include <functional>

namespace pdr::remote {
namespace {

/// Connections that the system queues while this program is busy: with fewer, a burst of strangers would keep others
/// out.
constexpr int kBacklog = 4096;
constexpr std::chrono::seconds kOutOfDescriptors{1};

/// Server that passes connections on as descriptors.
class Door : public QTcpServer {
  public:
    explicit Door(std::function<void(qintptr)> arrived) : arrived_(std::move(arrived)) {}

  protected:
    void incomingConnection(qintptr descriptor) override { arrived_(descriptor); }

  private:
    std::function<void(qintptr)> arrived_;
};

}  // namespace

Listener::Listener(const Identity& identity, const ListenerLimits& limits, QObject* parent)
    : QObject(parent),
      identity_(identity),
      limits_(limits),
      server_(std::make_unique<Door>([this](qintptr descriptor) { arrive(descriptor); })) {
    server_->setProxy(QNetworkProxy::NoProxy);
    server_->setListenBacklogSize(kBacklog);
    // Qt stops accepting when the system has no descriptor left.
    connect(server_.get(), &QTcpServer::acceptError, this,
            [this] { QTimer::singleShot(kOutOfDescriptors, server_.get(), &QTcpServer::resumeAccepting); });
}

Listener::~Listener() = default;

Result<void> Listener::listen(const Address& address) {
    const bool isName = address.host.compare("localhost", Qt::CaseInsensitive) == 0;
    const QHostAddress host = address.host.isEmpty() ? QHostAddress(QHostAddress::Any)
                              : isName               ? QHostAddress(QHostAddress::LocalHost)
                                                     : QHostAddress(address.host);
    if (host.isNull())
        return Error{phrase("this program listens at IP addresses, not at names"), address.text().toStdString(),
                     phrase("Give one of this machine's IP addresses, or the port alone."), ErrorKind::refused};
    if (!server_->listen(host, address.port))
        return Error{phrase("nobody can be listened to there: %1", server_->errorString().toStdString()),
                     address.text().toStdString(), phrase("Choose another port.")};
    return {};
}

Address Listener::address() const {
    return {server_->serverAddress().toString(), server_->serverPort()};
}

void Listener::arrive(qintptr descriptor) {
    makeRoom();
    auto* guest = new Guest(descriptor, identity_, limits_.handshake, this);
    waiting_.append(guest);
    connect(guest, &Guest::spoke, this, &Listener::seat);
    connect(guest, &Guest::known, this, [this, guest] { welcome(guest); });
    connect(guest, &Guest::gone, this, [this, guest](const QString& reason) { turnAway(guest, reason); });
    if (guest->hasSpoken())
        seat();
}

/// Turns away the connection that has been silent for longest or, if all wait for a place, the one that arrived first.
void Listener::makeRoom() {
    if (waiting_.size() < limits_.waiting)
        return;
    const auto silent = std::ranges::find_if(waiting_, [](const Guest* guest) { return !guest->hasSpoken(); });
    turnAway(silent == waiting_.end() ? waiting_.front() : *silent, "too many others came");
}

void Listener::seat() {
    for (qsizetype next = 0; next < waiting_.size() && places_.size() < limits_.inAll;) {
        Guest* guest = waiting_[next];
        if (!guest->hasSpoken() || !hasPlaceFor(guest->host())) {
            ++next;
            continue;
        }
        waiting_.removeAt(next);
        places_.insert(guest, guest->host());
        guest->letIn();
    }
}

bool Listener::hasPlaceFor(const QString& host) const {
    return std::count(places_.begin(), places_.end(), host) < limits_.perAddress;
}

void Listener::welcome(Guest* guest) {
    auto* channel = new Channel(guest->takeSocket(), identity_.role, limits_.channel, this);
    places_.insert(channel, guest->host());
    const auto giveBack = [this, channel] { release(channel); };
    connect(channel, &Channel::admitted, this, giveBack);
    connect(channel, &Channel::closed, this, giveBack);
    connect(channel, &Channel::destroyed, this, giveBack);
    release(guest);
    guest->deleteLater();
    emit connected(channel);
}

void Listener::turnAway(Guest* guest, const QString& reason) {
    guest->disconnect(this);
    guest->deleteLater();
    waiting_.removeOne(guest);
    emit turnedAway(guest->name(), reason);
    release(guest);
}

void Listener::release(QObject* guestOrChannel) {
    if (places_.remove(guestOrChannel) > 0)
        seat();
}

}  // namespace pdr::remote
