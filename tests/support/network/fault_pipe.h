#pragma once
/// Applies the faults of a bad network to the bytes of one connection in one direction.

#include <QElapsedTimer>
#include <QTcpSocket>
#include <QTimer>
#include <chrono>
#include <deque>
#include <functional>
#include <optional>
#include <random>

namespace pdr::test {

/// Faults of one direction. Bytes are counted from 0 from the connection's first byte in this direction, so that a
/// fault does not depend on how the system cuts the stream into pieces.
struct NetworkFault {
    std::chrono::milliseconds delay{0};
    qint64 bytesPerSecond = 0;         ///< 0: unlimited
    qint64 mostPiece = 0;              ///< largest piece; the seed determines the sizes; 0: pieces as they arrive
    bool stall = false;                ///< nothing passes and nothing is taken, as long as this is set
    bool blackHole = false;            ///< everything is taken and nothing passes
    std::optional<qint64> corrupt;     ///< the lowest bit of this byte is flipped
    std::optional<qint64> duplicate;   ///< this byte and up to 63 bytes behind it are sent twice
    std::optional<qint64> resetAfter;  ///< after so many bytes both sides get a reset
    std::optional<qint64> endAfter;    ///< after so many bytes this direction ends; the other continues
};

class FaultPipe : public QObject {
  public:
    /// `reset` is called when the connection is to be reset.
    FaultPipe(QTcpSocket* from, QTcpSocket* to, const NetworkFault& fault, std::uint64_t seed,
              std::function<void()> reset);

    void set(const NetworkFault& fault);
    /// Ends this direction, after the bytes that are in flight.
    void end();
    qint64 passed() const { return passed_; }

  private:
    struct Piece {
        qint64 due;  ///< time on clock_ [ms]
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
    double lineFree_ = 0;  ///< time on clock_ at which a line of that rate is free [ms]
    bool ended_ = false, over_ = false;
};

}  // namespace pdr::test
