#include "ui/nodes/node_address.h"

#include <QCoreApplication>
#include <QUrl>

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("nodeAddress", text);
}

TypedAddress problem(const QString& sentence) {
    return {{}, sentence};
}

/// What stands behind the colon; empty: there is none. Colons inside of brackets belong to the host.
QString portOf(const QString& text) {
    const qsizetype colon = text.lastIndexOf(':');
    return colon > text.lastIndexOf(']') ? text.mid(colon + 1) : QString();
}

bool isPort(const QString& text) {
    bool isNumber = false;
    const int port = text.toInt(&isNumber);
    return isNumber && port >= 1 && port <= 65535;
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
    if (!text.startsWith('[') && text.count(':') > 1)
        return problem(translated("An IPv6 address stands in brackets: [%1] or [%1]:%2.").arg(text).arg(kNodePort));
    if (const QString port = portOf(text); !isPort(port) && (!port.isEmpty() || text.endsWith(':')))
        return problem(translated("\"%1\" is no port: ports are numbers from 1 to 65535.").arg(port));
    QUrl url;
    url.setScheme("pdr");
    url.setAuthority(text, QUrl::StrictMode);
    if (!url.isValid() || url.host().isEmpty() || !url.userInfo().isEmpty())
        return problem(translated("\"%1\" is no host: names have letters, digits, dots and hyphens.").arg(text));
    const QString host = url.host(QUrl::FullyEncoded);
    const QString bracketed = host.contains(':') && !host.startsWith('[') ? '[' + host + ']' : host;
    return {QString("%1:%2").arg(bracketed).arg(url.port(kNodePort)), {}};
}

}  // namespace pdr::ui
