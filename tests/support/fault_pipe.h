#pragma once
/// What a bad network does to the bytes of one connection in one direction.

#include <QElapsedTimer>
#include <QTcpSocket>
#include <QTimer>
#include <chrono>
#include <deque>
#include <functional>
#include <optional>
#include <random>

namespace pdr::test {

/// Bytes are counted from the connection's first, in this direction, from 0: what a fault meets does not depend on how
/// the system cuts the stream into pieces.
struct NetworkFault {
    std::chrono::milliseconds delay{0};
    qint64 bytesPerSecond = 0;         ///< 0: as fast as it goes
    qint64 mostPiece = 0;              ///< pieces of 1 to so many bytes, as the seed says; 0: as they come
    bool stall = false;                ///< nothing passes and nothing is taken, as long as this is set
    bool blackHole = false;            ///< everything is taken and nothing passes
    std::optional<qint64> corrupt;     ///< the lowest bit of this byte is flipped
    std::optional<qint64> duplicate;   ///< this byte and up to 63 behind it come twice
    std::optional<qint64> resetAfter;  ///< so many bytes both sides get a reset
    std::optional<qint64> endAfter;    ///< so many bytes this direction ends; the other goes on
};

class FaultPipe : public QObject {
  public:
    /// `reset` is called when the connection is to be reset.
    FaultPipe(QTcpSocket* from, QTcpSocket* to, const NetworkFault& fault, std::uint64_t seed,
              std::function<void()> reset);

    void set(const NetworkFault& fault);
    /// This direction ends, behind what is on its way.
    void end();
    qint64 passed() const { return passed_; }

  private:
    struct Piece {
        qint64 due;  ///< clock_'s milliseconds
        QByteArray bytes;
    };
    void work();
    bool takePiece();
    void damage(QByteArray& bytes) const;
    void deliver();
    bool isDrained() const { return pieces_.empty() && to_->bytesToWrite() == 0; }

    QTcpSocket* from_;
    QTcpSocket* to_;
    NetworkFault fault_;
    std::mt19937_64 random_;
    std::function<void()> reset_;
    QElapsedTimer clock_;
    QTimer later_;
    std::deque<Piece> pieces_;
    qint64 taken_ = 0, passed_ = 0, queued_ = 0;
    double lineFree_ = 0;  ///< clock_'s milliseconds at which a line of that rate is free
    bool ended_ = false, over_ = false;
};

}  // namespace pdr::test
