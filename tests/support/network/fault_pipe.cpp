#include "tests/support/network/fault_pipe.h"

#include <sys/socket.h>

#include <algorithm>

namespace pdr::test {
namespace {

constexpr qint64 kMostQueued = 256 << 10, kPiece = 16 << 10, kDuplicated = 64;

}  // namespace

FaultPipe::FaultPipe(QTcpSocket* from, QTcpSocket* to, const NetworkFault& fault, std::uint64_t seed,
                     std::function<void()> reset)
    : from_(from), to_(to), fault_(fault), random_(seed), reset_(std::move(reset)) {
    clock_.start();
    later_.setSingleShot(true);
    from_->setReadBufferSize(kMostQueued);
    connect(&later_, &QTimer::timeout, this, &FaultPipe::work);
    connect(from_, &QTcpSocket::readyRead, this, &FaultPipe::work);
    connect(from_, &QTcpSocket::disconnected, this, &FaultPipe::work);
    connect(to_, &QTcpSocket::bytesWritten, this, &FaultPipe::work);
    connect(to_, &QTcpSocket::connected, this, &FaultPipe::work);
}

void FaultPipe::set(const NetworkFault& fault) {
    fault_ = fault;
    later_.start(0);
}

void FaultPipe::end() {
    ended_ = true;
    later_.start(0);
}

void FaultPipe::work() {
    if (over_ || to_->state() != QAbstractSocket::ConnectedState)
        return;
    while (from_->isOpen() && !fault_.stall && !ended_ && queued_ + to_->bytesToWrite() < kMostQueued && takePiece()) {
    }
    deliver();
    if (!isDrained())
        return;
    if (fault_.resetAfter && taken_ >= *fault_.resetAfter) {
        over_ = true;
        reset_();
    } else if (ended_) {
        over_ = true;
        shutdown(int(to_->socketDescriptor()), SHUT_WR);
    } else if (from_->state() == QAbstractSocket::UnconnectedState && from_->bytesAvailable() == 0) {
        over_ = true;
        to_->disconnectFromHost();
    }
}

bool FaultPipe::takePiece() {
    qint64 most = fault_.mostPiece > 0 ? 1 + qint64(random_() % std::uint64_t(fault_.mostPiece)) : kPiece;
    for (const auto& last : {fault_.resetAfter, fault_.endAfter})
        if (last)
            most = std::min(most, *last - taken_);
    QByteArray bytes = from_->read(std::max<qint64>(most, 0));
    const qint64 length = bytes.size();
    damage(bytes);
    taken_ += length;
    ended_ = ended_ || (fault_.endAfter && taken_ >= *fault_.endAfter);
    if (length == 0 || fault_.blackHole)
        return length > 0;
    const double now = double(clock_.elapsed());
    if (fault_.bytesPerSecond > 0)
        lineFree_ = std::max(lineFree_, now) + 1000.0 * double(bytes.size()) / double(fault_.bytesPerSecond);
    const double sent = fault_.bytesPerSecond > 0 ? lineFree_ : now;
    queued_ += bytes.size();
    pieces_.push_back({qint64(sent) + fault_.delay.count(), bytes});
    return true;
}

void FaultPipe::damage(QByteArray& bytes) const {
    const auto isHere = [&](const std::optional<qint64>& byte) {
        return byte && *byte >= taken_ && *byte < taken_ + bytes.size();
    };
    if (isHere(fault_.corrupt))
        bytes[*fault_.corrupt - taken_] = char(bytes[*fault_.corrupt - taken_] ^ 1);
    if (isHere(fault_.duplicate)) {
        const QByteArray twice = bytes.mid(*fault_.duplicate - taken_, kDuplicated);
        bytes.insert(*fault_.duplicate - taken_, twice);
    }
}

void FaultPipe::deliver() {
    while (!pieces_.empty() && !fault_.stall) {
        const qint64 wait = pieces_.front().due - clock_.elapsed();
        if (wait > 0) {
            later_.start(int(wait));
            return;
        }
        const QByteArray bytes = std::move(pieces_.front().bytes);
        pieces_.pop_front();
        queued_ -= bytes.size();
        passed_ += bytes.size();
        to_->write(bytes);
        if (fault_.mostPiece > 0)
            to_->flush();
    }
}

}  // namespace pdr::test
