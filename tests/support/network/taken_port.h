#pragma once
/// Ports of this machine for tests.

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <QtGlobal>

namespace pdr::test {

/// A port at which this program listens as long as the object exists.
class TakenPort {
  public:
    TakenPort() {
        sockaddr_in address{};
        socklen_t size = sizeof address;
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        auto* any = reinterpret_cast<sockaddr*>(&address);
        if (bind(socket_, any, size) != 0 || listen(socket_, 1) != 0 || getsockname(socket_, any, &size) != 0)
            qFatal("there is no free port");
        number_ = ntohs(address.sin_port);
    }
    ~TakenPort() { close(socket_); }
    TakenPort(const TakenPort&) = delete;
    TakenPort& operator=(const TakenPort&) = delete;

    quint16 number() const { return number_; }

  private:
    int socket_ = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    quint16 number_ = 0;
};

/// Returns a port at which no program listens now.
inline quint16 freePort() {
    return TakenPort().number();
}

}  // namespace pdr::test
