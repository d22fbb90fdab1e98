#include "ui/window/panel_title.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include "ui/window/key_tip.h"

namespace pdr::ui {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(WindowDocks)
};

}  // namespace

QWidget* panelTitle(const QString& title, QAction& toggle) {
    auto* heading = new QLabel(title);
    heading->setForegroundRole(QPalette::PlaceholderText);
    auto* fold = new QToolButton;
    fold->setText(QChar(0x00D7));
    fold->setAutoRaise(true);
    fold->setFocusPolicy(Qt::TabFocus);
    fold->setAccessibleName(Texts::tr("Close %1").arg(title));
    fold->setToolTip(keyTip(Texts::tr("Close panel"), toggle));
    QObject::connect(fold, &QToolButton::clicked, &toggle, &QAction::trigger);

    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(10, 4, 6, 2);
    row->addWidget(heading, 1);
    row->addWidget(fold);
    return bar;
}

}  // namespace pdr::ui
