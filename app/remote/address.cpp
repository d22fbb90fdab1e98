#include "app/remote/address.h"

#include <QHostAddress>
#include <algorithm>

namespace pdr::remote {
namespace {

Error notAnAddress(const QString& text) {
    return {phrase("this is no address"), text.toStdString(),
            phrase("Give HOST or HOST:PORT, with an IPv6 address in brackets: [::1]:4743."), ErrorKind::refused};
}

Error noSuchPort(const QString& text) {
    return {phrase("there is no such port"), text.toStdString(), phrase("Ports are numbers from 1 to 65535."),
            ErrorKind::refused};
}

/// Parses an address; accepts port 0, too.
Result<Address> parseAnyPort(const QString& text) {
    const auto read = readNetworkAddress(text.toStdString());
    if (const auto* address = std::get_if<NetworkAddress>(&read))
        return Address{QString::fromStdString(address->host), address->port};
    return std::get<AddressFault>(read) == AddressFault::port ? noSuchPort(text) : notAnAddress(text);
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
    bool fits = false;
    const quint16 port = text.toUShort(&fits);
    return fits ? Result(Address{"", port}) : noSuchPort(text);
}

}  // namespace pdr::remote
