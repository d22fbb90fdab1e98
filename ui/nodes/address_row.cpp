#include "ui/nodes/address_row.h"

#include <QHBoxLayout>

#include "render/base/network_address.h"
#include "ui/nodes/node_address.h"

namespace pdr::ui {

AddressRow::AddressRow(QWidget* parent) : QWidget(parent), add_(tr("Add")) {
    field_.setAccessibleName(tr("Address of a node"));
    field_.setPlaceholderText(tr("host or host:port"));
    field_.setToolTip(tr("Where a machine waits that is to render along: one on which \"pdrender-node --listen\" runs. "
                         "Without a port it is %1.")
                          .arg(kNodePort));
    field_.setClearButtonEnabled(true);
    field_.setMinimumWidth(fontMetrics().averageCharWidth() * 18);
    add_.setAccessibleName(tr("Add the node"));
    add_.setFocusPolicy(Qt::TabFocus);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&field_, 1);
    row->addWidget(&add_);
    connect(&field_, &QLineEdit::returnPressed, this, &AddressRow::add);
    connect(&field_, &QLineEdit::textEdited, this, [this] { emit problemFound({}); });
    connect(&add_, &QPushButton::clicked, this, &AddressRow::add);
}

/// Requests the node, or reports the problem. A wrong address stays in the field, to be corrected.
void AddressRow::add() {
    const TypedAddress typed = readAddress(field_.text());
    emit problemFound(typed.problem);
    if (!typed.problem.isEmpty())
        return field_.setFocus();
    field_.clear();
    emit addRequested(typed.address);
}

}  // namespace pdr::ui
