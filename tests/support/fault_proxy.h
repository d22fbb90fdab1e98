#pragma once
/// A bad network between two programs of one machine: they connect to its port instead of the server's. Works on a
/// thread of its own, below TLS. What it does to bytes depends on the seed alone, not on when they come.

#include <QThread>
#include <memory>

#include "tests/support/fault_pipe.h"

namespace pdr::test {

enum class Direction { toServer, toClient };

class FaultProxy {
  public:
    /// Between its own port() and `server`, both at 127.0.0.1.
    explicit FaultProxy(quint16 server, std::uint64_t seed = 1);
    ~FaultProxy();

    quint16 port() const { return port_; }
    /// For connections that there are, and those to come.
    void set(Direction direction, const NetworkFault& fault);
    /// All connections are reset.
    void reset();
    /// That direction of all connections ends, the other goes on.
    void end(Direction direction);
    /// Connections that there were.
    int connections() const;
    /// Bytes that were delivered in that direction.
    qint64 passed(Direction direction) const;

  private:
    class Relay;
    struct Link;
    template <class Work>
    void onThread(const Work& work) const;

    QThread thread_;
    Relay* relay_;
    quint16 port_ = 0;
};

}  // namespace pdr::test
