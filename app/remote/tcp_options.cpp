#include "app/remote/tcp_options.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

namespace pdr::remote {
namespace {

constexpr qint64 kReadBuffer = 1 << 20;
constexpr int kIdleSeconds = 2, kProbeSeconds = 1, kProbes = 3;

void setTcp(QTcpSocket& socket, int option, int value) {
    setsockopt(int(socket.socketDescriptor()), IPPROTO_TCP, option, &value, sizeof value);
}

}  // namespace

void setOptions(QTcpSocket& socket, std::chrono::milliseconds unheard) {
    socket.setReadBufferSize(kReadBuffer);
    socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
    socket.setSocketOption(QAbstractSocket::KeepAliveOption, 1);
    setTcp(socket, TCP_KEEPIDLE, kIdleSeconds);
    setTcp(socket, TCP_KEEPINTVL, kProbeSeconds);
    setTcp(socket, TCP_KEEPCNT, kProbes);
    setTcp(socket, TCP_USER_TIMEOUT, int(unheard.count()));
}

}  // namespace pdr::remote
