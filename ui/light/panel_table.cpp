#include "ui/light/panel_table.h"

#include <QColorDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "render/scene/light_rig.h"
#include "ui/widgets/screen_colour.h"

namespace pdr::ui {
namespace {

struct Angles {
    double azimuth, elevation;  ///< [degrees]; to the right from the viewer, and up
};

Angles anglesOf(dvec3 from) {
    const dvec3 unit = glm::normalize(from);
    return {glm::degrees(std::atan2(unit.x, unit.z)), glm::degrees(std::asin(std::clamp(unit.y, -1.0, 1.0)))};
}

dvec3 directionOf(const Angles& angles) {
    const double azimuth = glm::radians(angles.azimuth), elevation = glm::radians(angles.elevation);
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), std::cos(azimuth) * std::cos(elevation)};
}

double numberOf(const RigPanel& panel, int column) {
    switch (column) {
        case PanelTable::azimuth:
            return anglesOf(panel.from).azimuth;
        case PanelTable::elevation:
            return anglesOf(panel.from).elevation;
        case PanelTable::distance:
            return panel.distance;
        case PanelTable::edge:
            return panel.edge;
        default:
            return double(panel.radiance);
    }
}

void setNumber(RigPanel& panel, int column, double value) {
    Angles angles = anglesOf(panel.from);
    switch (column) {
        case PanelTable::azimuth:
            angles.azimuth = value;
            panel.from = directionOf(angles);
            break;
        case PanelTable::elevation:
            angles.elevation = std::clamp(value, -90.0, 90.0);
            panel.from = directionOf(angles);
            break;
        case PanelTable::distance:
            panel.distance = value;
            break;
        case PanelTable::edge:
            panel.edge = value;
            break;
        default:
            panel.radiance = float(value);
    }
}

/// Returns a lamp's colour for the screen. Whatever its brightness, its brightest channel is shown at full value.
QColor shownColour(vec3 colour) {
    const float brightest = std::max({colour.x, colour.y, colour.z});
    return screenColour(brightest > 0 ? colour / brightest : vec3(0));
}

}  // namespace

PanelTable::PanelTable(QWidget* parent) : QWidget(parent), add_(tr("Add")), remove_(tr("Remove")) {
    cells_.setColumnCount(kColumns);
    cells_.setHorizontalHeaderLabels(
        {tr("Lamp"), tr("Right°"), tr("Up°"), tr("Away"), tr("Edge"), tr("Radiance"), QString()});
    const QStringList tips{tr("Panels of one name are one lamp: they are moved and dimmed together"),
                           tr("From the viewer to the right; beyond 90 degrees it stands behind [degrees]. Of the "
                              "view from the front where the lamps turn with the patient"),
                           tr("Up [degrees]"),
                           tr("From the volume's middle [radii of the volume]"),
                           tr("Length of its edge [radii of the volume]"),
                           tr("Radiance, in the units of the exposure"),
                           tr("Colour of its light: double click it")};
    for (int column = 0; column < kColumns; ++column)
        cells_.horizontalHeaderItem(column)->setToolTip(tips[column]);
    cells_.verticalHeader()->hide();
    cells_.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    cells_.setSelectionBehavior(QAbstractItemView::SelectRows);
    cells_.setSelectionMode(QAbstractItemView::SingleSelection);
    cells_.setMinimumHeight(130);
    cells_.setTabKeyNavigation(false);
    cells_.setAccessibleName(tr("Panels of light"));
    add_.setToolTip(tr("Adds a panel like the chosen one, as a lamp of its own"));
    for (QPushButton* button : {&add_, &remove_})
        button->setFocusPolicy(Qt::TabFocus);
    auto* row = new QHBoxLayout;
    row->addWidget(&add_);
    row->addWidget(&remove_);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(&cells_);
    column->addLayout(row);
    connect(&cells_, &QTableWidget::cellChanged, this, &PanelTable::takeTyped);
    connect(&cells_, &QTableWidget::cellActivated, this, [this](int row, int cell) {
        if (cell == colour)
            askForColour(row);
    });
    connect(&add_, &QPushButton::clicked, this, &PanelTable::add);
    connect(&remove_, &QPushButton::clicked, this, &PanelTable::remove);
}

void PanelTable::setPanels(const std::vector<RigPanel>& panels) {
    if (panels == panels_)
        return;
    panels_ = panels;
    fill();
}

void PanelTable::fill() {
    const QSignalBlocker silent(&cells_);
    cells_.setRowCount(int(panels_.size()));
    for (int row = 0; row < int(panels_.size()); ++row) {
        const RigPanel& panel = panels_[std::size_t(row)];
        for (int column = 0; column < kColumns; ++column) {
            auto* item = new QTableWidgetItem;
            if (column == name)
                item->setText(QString::fromStdString(panel.name));
            else if (column == colour)
                item->setFlags(item->flags() & ~Qt::ItemIsEditable);
            else
                item->setText(QString::number(numberOf(panel, column), 'g', 4));
            cells_.setItem(row, column, item);
        }
        cells_.item(row, colour)->setBackground(shownColour(panel.colour));
        cells_.item(row, colour)->setData(Qt::AccessibleTextRole, shownColour(panel.colour).name());
    }
    add_.setEnabled(panels_.size() < LightRig::kMostPanels);
    remove_.setEnabled(panels_.size() > 1);
}

/// Takes a typed value. Decimal points and commas are accepted in any language.
void PanelTable::takeTyped(int row, int column) {
    std::vector<RigPanel> panels = panels_;
    RigPanel& panel = panels[std::size_t(row)];
    const QString text = cells_.item(row, column)->text();
    bool isNumber = true;
    if (column == name)
        panel.name = text.toStdString();
    else if (column != colour)
        setNumber(panel, column, text.trimmed().replace(',', '.').toDouble(&isNumber));
    if (!isNumber || !check(panel))
        return fill();
    panels_ = panels;
    fill();
    emit panelsEdited(panels_);
}

void PanelTable::askForColour(int row) {
    RigPanel& panel = panels_[std::size_t(row)];
    const float brightest = std::max({panel.colour.x, panel.colour.y, panel.colour.z});
    const QColor chosen = QColorDialog::getColor(shownColour(panel.colour), this, tr("Colour of the light"));
    if (!chosen.isValid())
        return;
    panel.colour = linearColour(chosen) * (brightest > 0 ? brightest : 1.0f);
    fill();
    emit panelsEdited(panels_);
}

void PanelTable::add() {
    const int row = std::max(cells_.currentRow(), 0);
    RigPanel panel = panels_[std::size_t(row)];
    panel.name = tr("Lamp %1").arg(panels_.size() + 1).toStdString();
    panels_.push_back(panel);
    fill();
    cells_.setCurrentCell(int(panels_.size()) - 1, 0);
    emit panelsEdited(panels_);
}

void PanelTable::remove() {
    const int row = std::max(cells_.currentRow(), 0);
    panels_.erase(panels_.begin() + row);
    fill();
    emit panelsEdited(panels_);
}

}  // namespace pdr::ui
