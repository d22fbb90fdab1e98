#include "app/remote/address.h"

#include <QHostAddress>
#include <algorithm>

namespace pdr::remote {
namespace {

Error notAnAddress(const QString& text) {
    return {"this is no address", text.toStdString(),
            "Give HOST or HOST:PORT, with an IPv6 address in brackets: [::1]:4743.", ErrorKind::refused};
}

Error noSuchPort(const QString& text) {
    return {"there is no such port", text.toStdString(), "Ports are numbers from 1 to 65535.", ErrorKind::refused};
}

/// 0 as well.
Result<quint16> parsePort(const QString& digits, const QString& text) {
    bool ok = false;
    const uint port = digits.toUInt(&ok);
    if (!ok || port > 65535 || !digits[0].isDigit())
        return noSuchPort(text);
    return quint16(port);
}

bool isIpv6(const QString& host) {
    return QHostAddress(host).protocol() == QAbstractSocket::IPv6Protocol;
}

bool isHost(const QString& host) {
    const auto fits = [](QChar letter) {
        return letter > u' ' && letter.unicode() < 127 && letter != u'/' && letter != u'@';
    };
    return !host.isEmpty() && std::ranges::all_of(host, fits);
}

/// `colon`: where the port begins, or at the end.
Result<Address> split(const QString& text, const QString& host, qsizetype colon) {
    Address address{host};
    if (!isHost(host) || host.contains(u'['))
        return notAnAddress(text);
    if (colon == text.size())
        return address;
    if (text[colon] != u':')
        return notAnAddress(text);
    const auto port = parsePort(text.mid(colon + 1), text);
    if (!port)
        return port.error();
    address.port = *port;
    return address;
}

Result<Address> parseAnyPort(const QString& text) {
    if (text.startsWith(u'[')) {
        const qsizetype end = text.indexOf(u']');
        const QString host = text.mid(1, end - 1);
        if (end < 0 || !isIpv6(host))
            return notAnAddress(text);
        return split(text, host, end + 1);
    }
    if (text.count(u':') > 1)
        return isIpv6(text) ? Result(Address{text}) : notAnAddress(text);
    const qsizetype colon = text.contains(u':') ? text.indexOf(u':') : text.size();
    return split(text, text.left(colon), colon);
}

bool isNumber(const QString& text) {
    return !text.isEmpty() && std::ranges::all_of(text, [](QChar letter) { return letter >= u'0' && letter <= u'9'; });
}

}  // namespace

bool Address::isLoopback() const {
    return host.compare("localhost", Qt::CaseInsensitive) == 0 || QHostAddress(host).isLoopback();
}

QString Address::text() const {
    const QString shown = host.isEmpty() ? "*" : host.contains(u':') ? "[" + host + "]" : host;
    return shown + ":" + QString::number(port);
}

Result<Address> parseAddress(const QString& text) {
    auto address = parseAnyPort(text);
    if (address && address->port == 0)
        return noSuchPort(text);
    return address;
}

Result<Address> parseListening(const QString& text) {
    if (!isNumber(text))
        return parseAnyPort(text);
    const auto port = parsePort(text, text);
    return port ? Result(Address{"", *port}) : port.error();
}

}  // namespace pdr::remote
