#include "app/wire/line.h"

#include <QString>
#include <algorithm>

namespace pdr::wire {

namespace {

bool controls(QChar c) {
    return c.category() == QChar::Other_Control;
}

}  // namespace

bool isLine(std::string_view text) {
    const QByteArrayView bytes(text.data(), qsizetype(text.size()));
    return bytes.isValidUtf8() && std::ranges::none_of(QString::fromUtf8(bytes), controls);
}

std::string lineOf(std::string_view text, std::size_t mostBytes) {
    QString line = QString::fromUtf8(text.data(), qsizetype(text.size()));
    std::ranges::replace_if(line, controls, u' ');
    std::string bytes = line.toStdString();
    std::size_t end = std::min(bytes.size(), mostBytes);
    while (end > 0 && end < bytes.size() && (std::uint8_t(bytes[end]) & 0xc0) == 0x80)  // do not cut a character
        --end;
    bytes.resize(end);
    return bytes;
}

}  // namespace pdr::wire
