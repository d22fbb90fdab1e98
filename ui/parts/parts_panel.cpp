#include "ui/parts/parts_panel.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace pdr::ui {
namespace {

enum Column { kName, kVolume, kState, kFrom, kColumns };

/// Returns a square of that colour, as high as a line.
QIcon swatch(const QColor& colour, int side) {
    QPixmap pixmap(side, side);
    pixmap.fill(colour.isValid() ? colour : QColor(Qt::transparent));
    return pixmap;
}

}  // namespace

PartsPanel::PartsPanel(QWidget* parent) : QWidget(parent) {
    list_.setColumnCount(kColumns);
    list_.setHeaderLabels({tr("Part"), tr("Volume"), tr("Shown"), tr("From")});
    list_.setRootIsDecorated(false);
    list_.setUniformRowHeights(true);
    list_.setSelectionMode(QAbstractItemView::ExtendedSelection);
    list_.setAccessibleName(tr("Parts of the scan"));
    list_.header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    list_.header()->setSectionResizeMode(kName, QHeaderView::Stretch);
    list_.header()->setStretchLastSection(false);
    tinted_.setText(tr("C&olours on the slices"));
    tinted_.setToolTip(tr("Shows which voxels are in which part; hidden parts stay grey."));
    tinted_.setChecked(true);
    tinted_.setFocusPolicy(Qt::TabFocus);
    notes_.setWordWrap(true);
    notes_.setForegroundRole(QPalette::PlaceholderText);
    notes_.setAccessibleName(tr("What is to be known of the parts"));
    remove_.setText(tr("Remove all &parts"));
    remove_.setFocusPolicy(Qt::TabFocus);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    column->addLayout(sourceButtons());
    column->addWidget(&list_, 1);
    column->addLayout(styleButtons());
    column->addWidget(&tinted_);
    column->addWidget(&notes_);
    column->addWidget(&remove_);

    connect(&list_, &QTreeWidget::itemSelectionChanged, this, &PartsPanel::showSelection);
    connect(&tinted_, &QCheckBox::clicked, this, &PartsPanel::tintChosen);
    connect(&remove_, &QPushButton::clicked, this, &PartsPanel::removeWanted);
    setRows({});
}

/// Returns the buttons of all that parts can come from.
QLayout* PartsPanel::sourceButtons() {
    struct Source {
        QPushButton& button;
        QString text, toolTip;
        void (PartsPanel::*wanted)();
    };
    const std::array sources{
        Source{file_, tr("Open &label map..."),
               tr("Opens parts that another program has marked on this scan: NIfTI, NRRD, MetaImage or a DICOM "
                  "segmentation."),
               &PartsPanel::labelFileWanted},
        Source{folder_, tr("Folder of &masks..."), tr("Opens a folder with a file of this kind for each part."),
               &PartsPanel::labelFolderWanted},
        Source{vessels_, tr("Find &vessels"),
               tr("Finds vessels on a scan with contrast medium by density and geometry: a guess, to be checked."),
               &PartsPanel::vesselsWanted},
        Source{shells_, tr("Find skin, m&uscle"),
               tr("Finds skin and muscle by density and geometry: a guess, to be checked."), &PartsPanel::shellsWanted},
        Source{mirror_, tr("Mirrored &bone"),
               tr("Finds bone that one side has and the other lacks, such as what closes a defect of the skull."),
               &PartsPanel::mirrorWanted},
        Source{implants_, tr("Find &implants"), tr("Finds implants by the density of metal: a guess, to be checked."),
               &PartsPanel::implantsWanted}};
    auto* grid = new QGridLayout;
    for (int i = 0; i < int(sources.size()); ++i) {
        const Source& source = sources[std::size_t(i)];
        source.button.setText(source.text);
        source.button.setToolTip(source.toolTip);
        source.button.setFocusPolicy(Qt::TabFocus);
        grid->addWidget(&source.button, i / 2, i % 2);
        connect(&source.button, &QPushButton::clicked, this, [this, wanted = source.wanted] { emit(this->*wanted)(); });
    }
    return grid;
}

/// Returns the buttons of how the selected parts are shown.
QLayout* PartsPanel::styleButtons() {
    struct State {
        QPushButton& button;
        PartState state;
        QString text, toolTip;
    };
    const std::array states{
        State{shown_, PartState::shown, tr("&Show"), tr("Shows the selected parts.")},
        State{ghost_, PartState::ghost, tr("&Ghost"), tr("Shows the selected parts so thin that one sees through.")},
        State{hidden_, PartState::hidden, tr("&Hide"), tr("Hides the selected parts.")}};
    auto* grid = new QGridLayout;
    for (int i = 0; i < int(states.size()); ++i) {
        const State& state = states[std::size_t(i)];
        state.button.setText(state.text);
        state.button.setToolTip(state.toolTip);
        grid->addWidget(&state.button, 0, 2 * i, 1, 2);
        connect(&state.button, &QPushButton::clicked, this,
                [this, state = state.state] { emit stateChosen(selected(), state); });
    }
    colour_.setText(tr("&Colour..."));
    colour_.setToolTip(tr("Gives the selected parts a colour of their own."));
    connect(&colour_, &QPushButton::clicked, this, &PartsPanel::chooseColour);
    look_.setText(tr("L&ook of the part"));
    look_.setToolTip(tr("Gives the selected parts the curve and the colours of a look."));
    look_.setPopupMode(QToolButton::InstantPopup);
    look_.setMenu(&looks_);
    look_.setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(&colour_, 1, 0, 1, 3);
    grid->addWidget(&look_, 1, 3, 1, 3);
    for (QWidget* button : std::initializer_list<QWidget*>{&shown_, &ghost_, &hidden_, &colour_, &look_})
        button->setFocusPolicy(Qt::TabFocus);
    return grid;
}

void PartsPanel::setRows(const std::vector<PartRow>& rows) {
    if (rows == rows_ && !rows.empty())
        return;
    const bool sameParts = std::ranges::equal(rows, rows_, {}, &PartRow::name, &PartRow::name);
    const std::vector<int> before = sameParts ? selected() : std::vector<int>();
    const QSignalBlocker silent(list_);
    rows_ = rows;
    list_.clear();
    for (const PartRow& row : rows) {
        auto* item = new QTreeWidgetItem(&list_, {row.name, row.volume, row.state, row.from});
        item->setIcon(kName, swatch(row.colour, list_.fontMetrics().ascent()));
        item->setTextAlignment(kVolume, Qt::AlignRight | Qt::AlignVCenter);
        const QString tip = row.look.isEmpty() ? row.source : row.source + '\n' + tr("Look: %1").arg(row.look);
        for (int column = 0; column < kColumns; ++column)
            item->setToolTip(column, tip);
    }
    for (const int row : before)
        list_.topLevelItem(row)->setSelected(true);
    remove_.setEnabled(!rows.empty());
    tinted_.setEnabled(!rows.empty());
    showSelection();
}

void PartsPanel::setNotes(const QString& sentences) {
    notes_.setText(sentences);
    notes_.setVisible(!sentences.isEmpty());
}

void PartsPanel::setLooks(const QStringList& names) {
    looks_.clear();
    connect(looks_.addAction(tr("As all tissue")), &QAction::triggered, this,
            [this] { emit lookChosen(selected(), -1); });
    looks_.addSeparator();
    for (int i = 0; i < names.size(); ++i)
        connect(looks_.addAction(QString(names[i]).replace('&', "&&")), &QAction::triggered, this,
                [this, i] { emit lookChosen(selected(), i); });
}

void PartsPanel::setBusy(bool busy) {
    for (QPushButton* button : {&file_, &folder_, &vessels_, &shells_, &mirror_, &implants_})
        button->setEnabled(!busy);
}

std::vector<int> PartsPanel::selected() const {
    std::vector<int> rows;
    for (int row = 0; row < list_.topLevelItemCount(); ++row)
        if (list_.topLevelItem(row)->isSelected())
            rows.push_back(row);
    return rows;
}

void PartsPanel::chooseColour() {
    const std::vector<int> rows = selected();
    const QColor before = rows_[std::size_t(rows.back())].colour;
    const QColor colour = QColorDialog::getColor(before, this, tr("Colour of the part"));
    if (colour.isValid())
        emit colourChosen(rows, colour);
}

/// Offers what can be done with what is selected: the rest of the body has the look's own curve and colours.
void PartsPanel::showSelection() {
    const std::vector<int> rows = selected();
    const bool anyPart = !rows.empty() && rows.back() > 0;
    for (QPushButton* button : {&shown_, &ghost_, &hidden_})
        button->setEnabled(!rows.empty());
    colour_.setEnabled(anyPart);
    look_.setEnabled(anyPart);
}

}  // namespace pdr::ui
