#include "ui/window/side_bar.h"

#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/widgets/line_icon.h"
#include "ui/widgets/scrolled.h"
#include "ui/window/key_tip.h"
#include "ui/window/panel_title.h"

namespace pdr::ui {
namespace {

/// Returns a page: the panel below its heading, in a scroll area, since the window may be lower than the panel.
QWidget* pageOf(QWidget* panel, const QString& title, QAction& toggle) {
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(panelTitle(title, toggle));
    column->addWidget(scrolled(panel), 1);
    return page;
}

}  // namespace

SideBar::SideBar(QWidget* window)
    : QDockWidget(tr("Side bar"), window), row_(new QHBoxLayout), pages_(new QStackedWidget) {
    setObjectName("sideBar");  // the name under which the window state saves it
    setFeatures(QDockWidget::DockWidgetClosable);
    setTitleBarWidget(new QWidget);
    auto* body = new QWidget;
    auto* column = new QVBoxLayout(body);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    row_->setContentsMargins(6, 4, 6, 0);
    row_->setSpacing(2);
    row_->addStretch(1);
    column->addLayout(row_);
    column->addWidget(pages_, 1);
    setWidget(body);
    pages_->setFixedWidth(kWidth);
    toggleViewAction()->setObjectName("sideBarPanel");  // the name under which its key is saved
    toggleViewAction()->setShortcut(Qt::Key_F10);
    toggleViewAction()->setToolTip(tr("Shows or closes the panels at the right of the image."));
    connect(&tabs_, &QButtonGroup::idClicked, this, [this](int page) { choose(page, true); });
}

QAction* SideBar::add(QWidget* panel, const PanelInfo& info) {
    const int number = pages_->count();
    auto* toggle = new QAction(info.title, this);
    toggle->setCheckable(true);
    toggle->setShortcut(info.key);
    connect(toggle, &QAction::triggered, this, [this, number](bool shown) { choose(number, shown); });
    toggles_ << toggle;
    QWidget* page = pageOf(panel, info.title, *toggle);
    pages_->addWidget(page);
    pages_->setFixedWidth(std::max(pages_->minimumWidth(), page->minimumSizeHint().width()));
    QToolButton* tab = tabOf(info, *toggle);
    tabs_.addButton(tab, number);
    row_->insertWidget(number, tab);
    showState();
    return toggle;
}

QToolButton* SideBar::tabOf(const PanelInfo& info, const QAction& toggle) {
    constexpr int kIcon = 20;
    auto* tab = new QToolButton;
    tab->setIcon(lineIcon(info.name + "Panel"));
    tab->setIconSize({kIcon, kIcon});
    tab->setCheckable(true);
    tab->setAutoRaise(true);
    tab->setProperty("tab", true);  // by which the style sheet draws it
    tab->setFocusPolicy(Qt::TabFocus);
    tab->setAccessibleName(info.title);
    const auto tip = [tab, &toggle] { tab->setToolTip(keyTip(toggle.text(), toggle)); };
    connect(&toggle, &QAction::changed, tab, tip);
    tip();
    return tab;
}

void SideBar::choose(int page, bool shown) {
    pages_->setCurrentIndex(shown ? page : 0);
    setVisible(shown || page != 0);
}

void SideBar::setVisible(bool shown) {
    QDockWidget::setVisible(shown);
    showState();
    emit opened(shown);
}

/// Shows in tabs and actions which panel is seen.
void SideBar::showState() {
    const int page = pages_->currentIndex();
    if (QAbstractButton* tab = tabs_.button(page))
        tab->setChecked(true);
    for (int i = 0; i < toggles_.size(); ++i)
        toggles_[i]->setChecked(i == page && !isHidden());
}

}  // namespace pdr::ui
