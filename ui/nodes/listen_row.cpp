#include "ui/nodes/listen_row.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "render/base/network_address.h"
#include "ui/widgets/file_dialogs.h"

namespace pdr::ui {

ListenRow::ListenRow(QWidget* parent) : QWidget(parent) {
    listens_.setText(tr("Listen on port"));
    listens_.setAccessibleName(tr("Listen on port"));
    listens_.setToolTip(
        tr("Render nodes may dial in: \"pdrender-node --coordinator\" with this machine's name and this port."));
    port_.setAccessibleName(tr("Port"));
    port_.setRange(1, 65535);
    port_.setValue(kNodePort);
    port_.setKeyboardTracking(false);
    certificates_.setText(tr("Certificates..."));
    certificates_.setToolTip(
        tr("The folder of this machine's certificates, which \"pdrender-node --make-certificates\" "
           "has made: with them nodes on other machines may be used."));
    without_.setText(QChar(0x00D7));
    without_.setAutoRaise(true);
    without_.setAccessibleName(tr("Without certificates"));
    without_.setToolTip(tr("Without certificates: only nodes on this machine"));
    for (QWidget* control : std::initializer_list<QWidget*>{&listens_, &port_, &certificates_, &without_})
        control->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image
    port_.setFocusPolicy(Qt::StrongFocus);      // except in the field, which is typed into
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&listens_);
    row->addWidget(&port_);
    row->addSpacing(6);
    row->addWidget(&certificates_);
    row->addWidget(&without_);
    row->addStretch(1);
    connect(&listens_, &QCheckBox::toggled, this, &ListenRow::listen);
    connect(&port_, &QSpinBox::valueChanged, this, [this] {
        if (listens_.isChecked())
            listen();
    });
    connect(&certificates_, &QPushButton::clicked, this, &ListenRow::chooseFolder);
    connect(&without_, &QToolButton::clicked, this, [this] { emit bundleRequested({}); });
    setBundle({});
}

void ListenRow::setListening(std::optional<quint16> port) {
    const QSignalBlocker switchIsSilent(&listens_), portIsSilent(&port_);
    listens_.setChecked(port.has_value());
    if (port)
        port_.setValue(*port);
}

void ListenRow::setBundle(const QString& folder) {
    bundle_ = folder;
    without_.setVisible(!folder.isEmpty());
}

void ListenRow::listen() {
    emit listenRequested(listens_.isChecked() ? std::optional(quint16(port_.value())) : std::nullopt);
}

void ListenRow::chooseFolder() {
    if (const QString folder = askForCertificates(this, bundle_); !folder.isEmpty())
        emit bundleRequested(folder);
}

}  // namespace pdr::ui
