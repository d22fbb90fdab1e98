#include "ui/measure/marks_panel.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace pdr::ui {

MarksPanel::MarksPanel(QWidget* parent) : QWidget(parent), buttons_(new QGridLayout) {
    remove_.setText(tr("Remove"));
    remove_.setToolTip(tr("Removes the selected measurement (Delete)."));
    remove_.setEnabled(false);
    list_.setColumnCount(2);
    list_.setHeaderLabels({tr("Name"), tr("Value")});
    list_.setRootIsDecorated(false);
    list_.setUniformRowHeights(true);
    list_.setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    list_.setAccessibleName(tr("Measurements"));
    list_.header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_.header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    list_.header()->setStretchLastSection(false);
    list_.installEventFilter(this);

    auto* layout = new QVBoxLayout(this);
    layout->addLayout(buttons_);
    layout->addWidget(&list_, 1);
    layout->addWidget(&chart_);
    layout->addWidget(&remove_, 0, Qt::AlignRight);
    remove_.setFocusPolicy(Qt::TabFocus);

    connect(&remove_, &QToolButton::clicked, this, [this] { emit removed(idOf(list_.currentItem())); });
    connect(&list_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        remove_.setEnabled(item);
        if (item)
            emit selected(idOf(item));
    });
    connect(&list_, &QTreeWidget::itemChanged, this,
            [this](const QTreeWidgetItem* item) { emit renamed(idOf(item), item->text(0)); });
}

void MarksPanel::addTool(QAction* action) {
    constexpr int kColumns = 3;
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    const int count = buttons_->count();
    buttons_->addWidget(button, count / kColumns, count % kColumns);
}

std::uint64_t MarksPanel::idOf(const QTreeWidgetItem* item) const {
    return item ? rows_[std::size_t(list_.indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(item)))].id : 0;
}

void MarksPanel::setRows(const std::vector<MarkRow>& rows) {
    if (rows == rows_)
        return;
    const std::uint64_t current = idOf(list_.currentItem());
    const QSignalBlocker silent(list_);
    rows_ = rows;
    list_.clear();
    for (const MarkRow& row : rows) {
        auto* item = new QTreeWidgetItem(&list_, {row.name, row.value});
        item->setFlags(item->flags() | Qt::ItemIsEditable);
        item->setToolTip(0, row.causes);
        item->setToolTip(1, row.causes);
    }
    setSelected(current);
}

QTreeWidgetItem* MarksPanel::itemOf(std::uint64_t id) const {
    const auto row = std::ranges::find(rows_, id, &MarkRow::id);
    return row == rows_.end() ? nullptr : list_.topLevelItem(int(row - rows_.begin()));
}

void MarksPanel::setSelected(std::uint64_t id) {
    const QSignalBlocker silent(list_);
    list_.setCurrentItem(itemOf(id));
    remove_.setEnabled(list_.currentItem());
}

void MarksPanel::editName(std::uint64_t id) {
    if (QTreeWidgetItem* item = itemOf(id))
        list_.editItem(item, 0);
}

/// Removes the selected measurement without asking, since undo brings it back.
bool MarksPanel::eventFilter(QObject* list, QEvent* event) {
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete &&
        list_.currentItem()) {
        emit removed(idOf(list_.currentItem()));
        return true;
    }
    return QWidget::eventFilter(list, event);
}

}  // namespace pdr::ui
