#pragma once
/// A bad network between two programs of one machine: clients connect to its port instead of the server's. Works on a
/// thread of its own, below TLS. Its effect on the bytes depends on the seed alone, not on when they arrive.

#include <QThread>
#include <memory>

#include "tests/support/network/fault_pipe.h"

namespace pdr::test {

enum class Direction { toServer, toClient };

class FaultProxy {
  public:
    /// Relays between its own port() and the port `server`, both at 127.0.0.1.
    explicit FaultProxy(quint16 server, std::uint64_t seed = 1);
    ~FaultProxy();

    quint16 port() const { return port_; }
    /// Sets the faults of existing and future connections.
    void set(Direction direction, const NetworkFault& fault);
    /// Resets all connections.
    void reset();
    /// Ends that direction of all connections; the other continues.
    void end(Direction direction);
    /// Returns the number of connections so far.
    int connections() const;
    /// Returns the number of bytes that were delivered in that direction.
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
