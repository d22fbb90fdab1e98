#pragma once
/// What stands in the memory of another process.

#include <QByteArray>
#include <QFile>
#include <algorithm>
#include <optional>
#include <string_view>

namespace pdr::test {

/// Returns how often `bytes` stand in what `process` may write to. None: its memory cannot be read, by other users than
/// root; or it says nothing, since the address sanitizer keeps what was freed, and maps terabytes.
inline std::optional<int> timesInMemoryOf(qint64 process, std::string_view bytes) {
#ifdef __SANITIZE_ADDRESS__
    return std::nullopt;
#endif
    QFile maps(QString("/proc/%1/maps").arg(process)), memory(QString("/proc/%1/mem").arg(process));
    if (!maps.open(QIODevice::ReadOnly) || !memory.open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return std::nullopt;
    int found = 0;
    for (const QByteArray& line : maps.readAll().split('\n')) {
        const QList<QByteArray> range = line.split(' ').value(0).split('-');
        if (range.size() != 2 || !line.contains(" rw") || line.contains("[v"))
            continue;
        const qint64 from = range[0].toLongLong(nullptr, 16), to = range[1].toLongLong(nullptr, 16);
        constexpr qint64 kPiece = 16 << 20;
        for (qint64 at = from; at < to; at += kPiece) {
            if (!memory.seek(at))
                break;
            const QByteArray piece = memory.read(std::min(kPiece + qint64(bytes.size()), to - at));
            const std::string_view text(piece.constData(), std::size_t(piece.size()));
            for (auto place = text.find(bytes); place != std::string_view::npos; place = text.find(bytes, place + 1))
                ++found;
        }
    }
    return found;
}

}  // namespace pdr::test
