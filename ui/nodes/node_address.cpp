#include "ui/nodes/node_address.h"

#include <QCoreApplication>

#include "render/base/network_address.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("nodeAddress", text);
}

TypedAddress problem(const QString& sentence) {
    return {{}, sentence};
}

/// Returns the text after the last colon; empty if there is none. Colons inside brackets belong to the host.
QString portOf(const QString& text) {
    const qsizetype colon = text.lastIndexOf(':');
    return colon > text.lastIndexOf(']') ? text.mid(colon + 1) : QString();
}

}  // namespace

TypedAddress readAddress(const QString& typed) {
    const QString text = typed.trimmed();
    if (text.isEmpty())
        return problem(translated("Type the address of a node first, such as gpu-07 or 10.0.0.7:%1.").arg(kNodePort));
    if (text.contains("/"))
        return problem(translated("\"%1\" is no address of a node: only a host and a port, without slashes, such as "
                                  "gpu-07:%2.")
                           .arg(text)
                           .arg(kNodePort));
    const auto read = readNetworkAddress(text.toStdString());
    const auto* address = std::get_if<NetworkAddress>(&read);
    const AddressFault fault = address ? AddressFault::port : std::get<AddressFault>(read);
    if (address && address->port > 0) {
        const QString host = QString::fromStdString(address->host);
        return {QString(host.contains(':') ? "[%1]:%2" : "%1:%2").arg(host).arg(address->port), {}};
    }
    if (fault == AddressFault::brackets)
        return problem(translated("An IPv6 address stands in brackets: [%1] or [%1]:%2.").arg(text).arg(kNodePort));
    if (fault == AddressFault::port)
        return problem(translated("\"%1\" is no port: ports are numbers from 1 to 65535.").arg(portOf(text)));
    return problem(translated("\"%1\" is no host: names have letters, digits, dots and hyphens.").arg(text));
}

}  // namespace pdr::ui
