#include "app/remote/channel.h"

#include <QHostAddress>
#include <QSslSocket>
#include <limits>

#include "app/remote/address.h"
#include "app/remote/tcp_options.h"
#include "app/remote/tls.h"
#include "app/wire/frame_reader.h"
#include "app/wire/message_codec.h"

namespace pdr::remote {
namespace {

constexpr qint64 kReadPiece = 64 << 10;
constexpr std::size_t kWritePiece = 64 << 10;
/// Limit on the bytes in the socket: urgent messages can no longer overtake a chunk that is there.
constexpr qint64 kHandedOver = 256 << 10;
constexpr std::chrono::milliseconds kWatch{500};

/// Whether a message arrives as fast as work is done, so that the rate limit must not count it. Answers to leases are
/// checked by the side that gave out the leases.
bool isOfWork(const wire::Message& message) {
    return std::holds_alternative<wire::Lease>(message) || std::holds_alternative<wire::Result>(message) ||
           std::holds_alternative<wire::Abandoned>(message) || std::holds_alternative<wire::Chunk>(message);
}

}  // namespace

Channel::Channel(QTcpSocket* socket, Role role, const ChannelLimits& limits, QObject* parent)
    : QObject(parent),
      socket_(socket),
      limits_(limits),
      reader_(std::make_unique<wire::FrameReader>(role)),
      drip_(limits.drip),
      bucket_(limits.messages) {
    socket_->setParent(this);
    setOptions(*socket_, limits_.unheard);
    peerHost_ = socket_->peerAddress().toString();
    peerName_ = Address{peerHost_, socket_->peerPort()}.text();
    connect(socket_, &QTcpSocket::readyRead, this, &Channel::read);
    connect(socket_, &QTcpSocket::bytesWritten, this, &Channel::written);
    if (auto* tls = qobject_cast<QSslSocket*>(socket_)) {
        peerCertificate_ = ownName(tls->peerCertificate());
        connect(tls, &QSslSocket::encryptedBytesWritten, this, &Channel::written);
    }
    connect(socket_, &QTcpSocket::disconnected, this, [this] { lose(phrase("the other side ended the connection")); });
    connect(socket_, &QTcpSocket::errorOccurred, this, [this] { lose(socket_->errorString().toStdString()); });
    patience_.setSingleShot(true);
    connect(&patience_, &QTimer::timeout, this,
            [this] { finish(phrase("the other side did not introduce itself in time")); });
    patience_.start(limits_.admission);
    connect(&watchTimer_, &QTimer::timeout, this, &Channel::watch);
    watchTimer_.start(kWatch);
    clock_.start();
    QTimer::singleShot(0, this, &Channel::begin);
}

Channel::~Channel() {
    socket_->disconnect(this);
    socket_->abort();
}

/// Handles data and a disconnection that came before the socket's signals were connected.
void Channel::begin() {
    read();
    if (socket_->state() == QAbstractSocket::UnconnectedState)
        lose(phrase("the other side ended the connection"));
}

qint64 Channel::inSocket() const {
    const auto* tls = qobject_cast<const QSslSocket*>(socket_);
    return socket_->bytesToWrite() + (tls ? tls->encryptedBytesToWrite() : 0);
}

qint64 Channel::queuedBytes() const {
    return waiting_ + inSocket();
}

bool Channel::send(wire::Message message) {
    const bool chunk = std::holds_alternative<wire::Chunk>(message);
    if (state_ != State::open || (chunk && !hasRoom()))
        return false;
    wire::Frame frame = wire::encode(std::move(message));
    waiting_ += qint64(frame.bytes());
    (chunk ? chunks_ : urgent_).push_back(std::move(frame));
    if (queuedBytes() > kMostQueued) {
        finish(phrase("the other side takes too little of what it is sent"));
        return false;
    }
    pump(kHandedOver);
    wasFull_ = wasFull_ || !hasRoom();
    return true;
}

/// Writes queued bytes until `most` bytes are in the socket, or none are left.
void Channel::pump(qint64 most) {
    while (inSocket() < most && (handedOver_ < frame_.bytes() || beginNextFrame())) {
        const std::span<const std::byte> piece = nextPiece();
        const qint64 written = socket_->write(reinterpret_cast<const char*>(piece.data()), qint64(piece.size()));
        if (written <= 0)
            return;  // the socket reports the reason by a signal
        handedOver_ += std::size_t(written);
        waiting_ -= written;
        bytesSent_ += written;
    }
}

std::span<const std::byte> Channel::nextPiece() const {
    const bool inHead = handedOver_ < frame_.head.size();
    const std::span<const std::byte> part = inHead ? frame_.head : frame_.payload;
    const auto rest = part.subspan(handedOver_ - (inHead ? 0 : frame_.head.size()));
    return rest.first(std::min(rest.size(), kWritePiece));
}

bool Channel::beginNextFrame() {
    std::deque<wire::Frame>& queue = urgent_.empty() ? chunks_ : urgent_;
    handedOver_ = 0;
    frame_ = {};
    if (queue.empty())
        return false;
    frame_ = std::move(queue.front());
    queue.pop_front();
    return true;
}

void Channel::written() {
    if (state_ != State::open)
        return;
    pump(kHandedOver);
    if (wasFull_ && hasRoom()) {
        wasFull_ = false;
        emit roomForMore();
    }
}

void Channel::read() {
    while (state_ == State::open && socket_->bytesAvailable() > 0) {
        const QByteArray bytes = socket_->read(kReadPiece);
        if (bytes.isEmpty())
            return;
        bytesReceived_ += bytes.size();
        take(std::as_bytes(std::span(bytes.constData(), std::size_t(bytes.size()))));
    }
    if (state_ == State::closing)
        socket_->readAll();
}

void Channel::take(std::span<const std::byte> bytes) {
    while (state_ == State::open) {
        auto next = reader_->next(bytes);
        if (!next)
            return finish(next.error().text());
        flooded_ = isFlood(*next);
        if (flooded_)
            return finish(phrase("the other side sends more messages than it has reason to"));
        if (!*next)
            return;
        wire::Message& message = **next;
        if (!mayCome(message))
            return finish(phrase("the other side did not introduce itself first"));
        emit received(message);
    }
}

/// Whether messages arrive too fast: the newest one, and messages of unknown types that were skipped before it.
bool Channel::isFlood(const std::optional<wire::Message>& newest) {
    const qint64 come = reader_->messages() - counted_;
    counted_ += come;
    const qint64 counts = come - (newest && isOfWork(*newest) ? 1 : 0);
    return !bucket_.take(TokenBucket::Moment(clock_.nsecsElapsed() / 1000), counts);
}

bool Channel::mayCome(const wire::Message& message) const {
    return admitted_ || std::holds_alternative<wire::Hello>(message) ||
           std::holds_alternative<wire::Welcome>(message) || std::holds_alternative<wire::Refused>(message) ||
           std::holds_alternative<wire::Bye>(message);
}

void Channel::watch() {
    const std::chrono::milliseconds now(clock_.elapsed());
    if (state_ == State::open && drip_.tooSlow(now, bytesReceived_, reader_->messages(), reader_->isInside()))
        finish(phrase("the other side sends a message too slowly"));
}

void Channel::setAdmitted() {
    if (admitted_ || state_ != State::open)
        return;
    admitted_ = true;
    reader_->setAdmitted(true);
    patience_.stop();
    emit admitted();
}

void Channel::close(const Text& reason) {
    if (state_ != State::open)
        return;
    state_ = State::closing;
    reason_ = reason;
    for (const wire::Frame& chunk : chunks_)
        waiting_ -= qint64(chunk.bytes());
    chunks_.clear();
    pump(std::numeric_limits<qint64>::max());
    patience_.start(limits_.farewell);
    socket_->disconnectFromHost();
}

/// Ends a channel whose connection is lost. A peer that rejects this side's certificate only ends the connection and
/// gives no reason.
void Channel::lose(const Text& reason) {
    finish(admitted_ ? reason : phrase("%1, before both sides knew each other", reason));
}

void Channel::finish(const Text& reason) {
    if (state_ == State::over)
        return;
    if (state_ == State::open)
        reason_ = reason;
    state_ = State::over;
    patience_.stop();
    watchTimer_.stop();
    urgent_.clear();
    chunks_.clear();
    waiting_ = 0;
    socket_->disconnect(this);
    QTimer::singleShot(0, this, [this] {
        socket_->abort();
        emit closed(reason_);
    });
}

}  // namespace pdr::remote
