#include "ui/measure/marks_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace pdr::ui {

MarksPanel::MarksPanel(QWidget* parent)
    : QWidget(parent), distance_(tr("Distance")), angle_(tr("Angle")), remove_(tr("Remove")) {
    distance_.setToolTip(tr("Click two places of a slice (M). They move to the edge of a structure; Alt: they stay."));
    angle_.setToolTip(tr("Click three places of a slice (A): the angle at the second."));
    remove_.setToolTip(tr("Removes the selected measurement (Delete)."));
    distance_.setCheckable(true);
    angle_.setCheckable(true);
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

    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {&distance_, &angle_, &remove_}) {
        button->setFocusPolicy(Qt::TabFocus);
        buttons->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->addLayout(buttons);
    layout->addWidget(&list_, 1);

    connect(&distance_, &QPushButton::clicked, this, &MarksPanel::distanceChosen);
    connect(&angle_, &QPushButton::clicked, this, &MarksPanel::angleChosen);
    connect(&remove_, &QPushButton::clicked, this, [this] { emit removed(idOf(list_.currentItem())); });
    connect(&list_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
        remove_.setEnabled(item);
        if (item)
            emit selected(idOf(item));
    });
    connect(&list_, &QTreeWidget::itemChanged, this,
            [this](const QTreeWidgetItem* item) { emit renamed(idOf(item), item->text(0)); });
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

void MarksPanel::setSelected(std::uint64_t id) {
    const QSignalBlocker silent(list_);
    list_.setCurrentItem(nullptr);
    for (std::size_t i = 0; i < rows_.size(); ++i)
        if (rows_[i].id == id)
            list_.setCurrentItem(list_.topLevelItem(int(i)));
    remove_.setEnabled(list_.currentItem());
}

void MarksPanel::setDrawing(bool distance, bool angle) {
    distance_.setChecked(distance);
    angle_.setChecked(angle);
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
