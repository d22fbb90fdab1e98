#include "tests/support/network/fault_proxy.h"

#include <sys/socket.h>

#include <QHostAddress>
#include <QTcpServer>
#include <array>
#include <vector>

namespace pdr::test {
namespace {

void resetConnection(QTcpSocket& socket) {
    const linger atOnce{1, 0};
    if (socket.socketDescriptor() >= 0)
        setsockopt(int(socket.socketDescriptor()), SOL_SOCKET, SO_LINGER, &atOnce, sizeof atOnce);
    socket.abort();
}

}  // namespace

/// One connection: two sockets, and a pipe each way.
struct FaultProxy::Link {
    Link(QTcpSocket* accepted, quint16 port, const std::array<NetworkFault, 2>& faults, std::uint64_t seed)
        : client(accepted),
          toServer(client.get(), &server, faults[0], 2 * seed, [this] { reset(); }),
          toClient(&server, client.get(), faults[1], 2 * seed + 1, [this] { reset(); }) {
        for (QTcpSocket* socket : {client.get(), &server})
            socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
        // A client of a server that is not there gets a reset.
        QObject::connect(&server, &QTcpSocket::errorOccurred, client.get(), [this] {
            if (server.error() == QAbstractSocket::ConnectionRefusedError)
                reset();
        });
        server.connectToHost(QHostAddress::LocalHost, port);
    }
    void reset() {
        resetConnection(*client);
        resetConnection(server);
    }
    FaultPipe& pipe(Direction direction) { return direction == Direction::toServer ? toServer : toClient; }

    std::unique_ptr<QTcpSocket> client;
    QTcpSocket server;
    FaultPipe toServer, toClient;
};

/// The server and its links, which live on the proxy's thread.
class FaultProxy::Relay : public QTcpServer {
  public:
    Relay(quint16 server, std::uint64_t seed) : seed_(seed) {
        connect(this, &QTcpServer::newConnection, this, [this, server] {
            while (QTcpSocket* client = nextPendingConnection()) {
                client->setParent(nullptr);
                links.push_back(std::make_unique<Link>(client, server, faults, seed_++));
            }
        });
    }

    std::array<NetworkFault, 2> faults;
    std::vector<std::unique_ptr<Link>> links;

  private:
    std::uint64_t seed_;
};

template <class Work>
void FaultProxy::onThread(const Work& work) const {
    QMetaObject::invokeMethod(relay_, work, Qt::BlockingQueuedConnection);
}

FaultProxy::FaultProxy(quint16 server, std::uint64_t seed) : relay_(new Relay(server, seed)) {
    relay_->moveToThread(&thread_);
    QObject::connect(&thread_, &QThread::finished, relay_, &QObject::deleteLater);
    thread_.start();
    onThread([this] {
        relay_->listen(QHostAddress::LocalHost);
        port_ = relay_->serverPort();
    });
}

FaultProxy::~FaultProxy() {
    thread_.quit();
    thread_.wait();
}

void FaultProxy::set(Direction direction, const NetworkFault& fault) {
    onThread([&] {
        relay_->faults[direction == Direction::toServer ? 0 : 1] = fault;
        for (const auto& link : relay_->links)
            link->pipe(direction).set(fault);
    });
}

void FaultProxy::reset() {
    onThread([this] {
        for (const auto& link : relay_->links)
            link->reset();
    });
}

void FaultProxy::end(Direction direction) {
    onThread([&] {
        for (const auto& link : relay_->links)
            link->pipe(direction).end();
    });
}

int FaultProxy::connections() const {
    int count = 0;
    onThread([&] { count = int(relay_->links.size()); });
    return count;
}

qint64 FaultProxy::passed(Direction direction) const {
    qint64 bytes = 0;
    onThread([&] {
        for (const auto& link : relay_->links)
            bytes += link->pipe(direction).passed();
    });
    return bytes;
}

}  // namespace pdr::test
