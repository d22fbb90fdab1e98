#include "ui/nodes/nodes_panel.h"

#include <QDir>
#include <QHeaderView>
#include <QShortcut>
#include <algorithm>

#include "ui/nodes/node_text.h"

namespace pdr::ui {

NodesPanel::NodesPanel(QWidget* parent)
    : QWidget(parent),
      controlGroups_(new QBoxLayout(QBoxLayout::LeftToRight)),
      lastLines_(new QBoxLayout(QBoxLayout::TopToBottom)) {
    setUpTable();
    describe();
    layOut();
    connectControls();
    setBundle({});
    setProblem({});
    enableWhatCounts();
    showNotes();
}

/// Sets up the table. Every column has a fixed width or takes the rest, so that no update measures texts.
void NodesPanel::setUpTable() {
    table_.setModel(&model_);
    table_.setAccessibleName(tr("Render nodes"));
    table_.setSelectionBehavior(QAbstractItemView::SelectRows);
    table_.setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_.setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_.setTabKeyNavigation(false);
    table_.setShowGrid(false);
    table_.setWordWrap(false);
    table_.setTextElideMode(Qt::ElideRight);
    table_.setFrameShape(QFrame::NoFrame);
    table_.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_.verticalHeader()->hide();
    table_.verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    table_.verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
    QHeaderView& header = *table_.horizontalHeader();
    table_.setMinimumHeight(header.sizeHint().height() + table_.verticalHeader()->defaultSectionSize());
    header.setHighlightSections(false);
    header.setMinimumSectionSize(40);
    constexpr int kBesideText = 16;
    for (int column = 0; column < NodesModel::kColumns; ++column) {
        const QString widest = NodesModel::widest(column);
        header.setSectionResizeMode(column, widest.isEmpty() ? QHeaderView::Stretch : QHeaderView::Fixed);
        if (widest.isEmpty())
            continue;
        const QString title = model_.headerData(column, Qt::Horizontal).toString();
        header.resizeSection(column, kBesideText + std::max(fontMetrics().horizontalAdvance(widest),
                                                            header.fontMetrics().horizontalAdvance(title)));
    }
}

void NodesPanel::describe() {
    pause_.setToolTip(tr("Pause or resume the selected nodes (Space)"));
    remove_.setText(tr("Remove"));
    remove_.setToolTip(tr("Disconnect the selected nodes and erase the scan on them (Delete)"));
    for (QPushButton* button : {&pause_, &remove_})
        button->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image
    checksAll_.setText(tr("Check all"));
    checksAll_.setAccessibleName(checksAll_.text());
    checksAll_.setToolTip(
        tr("Render everything that render nodes send a second time, on another one or on this machine, "
           "before it is used: twice the work, and no false sample gets into the image"));
    checksAll_.setFocusPolicy(Qt::TabFocus);
    problem_.setAccessibleName(tr("What could not be done"));
    problem_.setWordWrap(true);
    problem_.setTextFormat(Qt::PlainText);
    security_.setAccessibleName(tr("Connection security"));
    notes_.setAccessibleName(tr("How the work is split"));
    for (QLabel* label : {static_cast<QLabel*>(&security_), static_cast<QLabel*>(&notes_)})
        label->setForegroundRole(QPalette::PlaceholderText);
}

void NodesPanel::layOut() {
    auto* node = new QWidget;
    auto* row = new QHBoxLayout(node);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&address_, 1);
    row->addWidget(&pause_);
    row->addWidget(&remove_);
    controlGroups_->setContentsMargins(0, 0, 0, 0);
    controlGroups_->setSpacing(6);
    controlGroups_->addWidget(node, 1);
    controlGroups_->addWidget(&listen_);
    auto* controls = new QWidget;
    controls->setLayout(controlGroups_);
    controls->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    setMinimumWidth(20 + std::max(node->minimumSizeHint().width(), listen_.minimumSizeHint().width()));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 2, 10, 6);
    column->setSpacing(4);
    column->addWidget(controls);
    column->addWidget(&problem_);
    column->addWidget(&table_, 1);
    lastLines_->setContentsMargins(0, 0, 0, 0);
    lastLines_->setSpacing(4);
    auto* split = new QHBoxLayout;
    split->addWidget(&splitBox_);
    split->addWidget(&checksAll_);
    split->addWidget(&notes_, 1);
    lastLines_->addLayout(split, 5);
    lastLines_->addWidget(&security_, 4);
    column->addLayout(lastLines_);
}

void NodesPanel::connectControls() {
    connect(&address_, &AddressRow::addRequested, this, &NodesPanel::addRequested);
    connect(&address_, &AddressRow::problemFound, this, &NodesPanel::setProblem);
    connect(&listen_, &ListenRow::listenRequested, this, [this](const std::optional<quint16>& port) {
        setProblem({});
        emit listenRequested(port);
    });
    connect(&listen_, &ListenRow::bundleRequested, this, [this](const QString& folder) {
        setProblem({});
        emit bundleRequested(folder);
    });
    connect(&splitBox_, &SplitBox::splitRequested, this, &NodesPanel::splitRequested);
    connect(&checksAll_, &QCheckBox::clicked, this, &NodesPanel::checksAllRequested);
    connect(table_.selectionModel(), &QItemSelectionModel::selectionChanged, this, &NodesPanel::enableWhatCounts);
    connect(&pause_, &QPushButton::clicked, this, &NodesPanel::pauseOrGoOn);
    connect(&remove_, &QPushButton::clicked, this, &NodesPanel::removeSelected);
    const auto onKey = [this](Qt::Key key, void (NodesPanel::*act)()) {
        connect(new QShortcut(key, &table_, nullptr, nullptr, Qt::WidgetShortcut), &QShortcut::activated, this, act);
    };
    onKey(Qt::Key_Space, &NodesPanel::pauseOrGoOn);
    onKey(Qt::Key_Delete, &NodesPanel::removeSelected);
}

void NodesPanel::setNodes(const QList<NodeRow>& nodes) {
    model_.setNodes(nodes);
    enableWhatCounts();
    showNotes();
}

void NodesPanel::setSplit(const QString& sentence) {
    split_ = sentence;
    showNotes();
}

void NodesPanel::setChecks(const QString& sentence) {
    checks_ = sentence;
    showNotes();
}

void NodesPanel::setBundle(const QString& folder) {
    listen_.setBundle(folder);
    security_.setLine(folder.isEmpty() ? tr("Without certificates connections are plain, and to this machine only")
                                       : tr("Encrypted, and each side proves who it is, by the certificates in %1")
                                             .arg(QDir::toNativeSeparators(folder)));
}

void NodesPanel::setProblem(const QString& sentence) {
    problem_.setText(sentence);
    problem_.setVisible(!sentence.isEmpty());
}

void NodesPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    int needed = 20 + controlGroups_->spacing();
    for (int i = 0; i < controlGroups_->count(); ++i)
        needed += controlGroups_->itemAt(i)->minimumSize().width();
    constexpr int kBothLines = 1000;
    const auto direction = [](bool room) { return room ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom; };
    controlGroups_->setDirection(direction(width() >= needed));
    lastLines_->setDirection(direction(width() >= kBothLines));
}

QList<NodeRow> NodesPanel::selected() const {
    QList<NodeRow> nodes;
    for (const QModelIndex& row : table_.selectionModel()->selectedRows())
        nodes << model_.nodes()[row.row()];
    return nodes;
}

bool NodesPanel::allPaused() const {
    const QList<NodeRow> nodes = selected();
    return !nodes.isEmpty() &&
           std::ranges::all_of(nodes, [](const NodeRow& node) { return node.state == NodeState::paused; });
}

void NodesPanel::enableWhatCounts() {
    const bool any = table_.selectionModel()->hasSelection();
    pause_.setEnabled(any);
    remove_.setEnabled(any);
    pause_.setText(any && allPaused() ? tr("Continue") : tr("Pause"));
}

void NodesPanel::pauseOrGoOn() {
    const bool pause = !allPaused();
    for (const NodeRow& node : selected())
        emit pauseRequested(node.id, pause);
}

void NodesPanel::removeSelected() {
    for (const NodeRow& node : selected())
        emit removeRequested(node.id);
}

void NodesPanel::showNotes() {
    QStringList notes{split_, checks_, bitsText(model_.nodes())};
    notes.removeAll({});
    if (model_.nodes().isEmpty())
        notes = QStringList{tr("No render nodes: other machines can render along, and the image becomes right sooner")};
    notes_.setLine(notes.join(QString::fromUtf8(" · ")));
}

}  // namespace pdr::ui
