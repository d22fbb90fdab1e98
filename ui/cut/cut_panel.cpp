#include "ui/cut/cut_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>

#include "ui/text/cut_text.h"

namespace pdr::ui {

CutPanel::CutPanel(QWidget* parent) : QWidget(parent), planeColumn_(new QVBoxLayout) {
    freehand_.setText(tr("Freehan&d cut"));
    freehand_.setToolTip(
        tr("Draw a closed outline on the image, then remove the tissue inside it, or everything else (X)"));
    removeLine_.setText(QChar(0x2212));
    removeLine_.setAccessibleName(tr("Remove the last one"));
    removeLine_.setToolTip(tr("Remove the last freehand cut"));
    removeLine_.setFocusPolicy(Qt::TabFocus);
    shadows_.setText(tr("Removed tissue casts &shadows"));
    shadows_.setToolTip(tr("Whether the tissue removed by box and planes still casts shadows"));
    undoAll_.setText(tr("Remove all c&uts"));
    for (QAbstractButton* button : std::initializer_list<QAbstractButton*>{&freehand_, &shadows_, &undoAll_})
        button->setFocusPolicy(Qt::TabFocus);

    // Lay out the panel
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    column->addWidget(new QLabel(tr("Cut off at each side")));
    column->addLayout(boxRows());
    column->addWidget(new QLabel(tr("Planes")));
    column->addLayout(planeButtons());
    column->addLayout(planeColumn_);
    column->addWidget(&freehand_);
    auto* lines = new QHBoxLayout;
    lines->addWidget(&lines_, 1);
    lines->addWidget(&removeLine_);
    column->addLayout(lines);
    column->addWidget(&shadows_);
    column->addStretch(1);
    column->addWidget(&undoAll_);

    // Connect the controls
    connect(&freehand_, &QPushButton::clicked, this, &CutPanel::freehandWanted);
    connect(&shadows_, &QCheckBox::clicked, this, [this](bool on) {
        Clip clip = clip_;
        clip.shadows = on;
        choose(clip);
    });
    connect(&removeLine_, &QToolButton::clicked, this, &CutPanel::removeLine);
    connect(&undoAll_, &QPushButton::clicked, this, [this] { choose({}); });
    setCuts({}, std::nullopt);
}

/// Returns the fields of the box, with opposite sides in one row.
QLayout* CutPanel::boxRows() {
    constexpr double kFarthestMm = 2e3;
    auto* grid = new QGridLayout;
    for (int face = 0; face < 6; ++face) {
        QDoubleSpinBox& side = sides_[std::size_t(face)];
        side.setRange(0, kFarthestMm);
        side.setDecimals(1);
        side.setSuffix(tr(" mm"));
        side.setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);  // beside the longest names of sides
        side.setKeyboardTracking(false);
        side.setAccessibleName(tr("Distance cut off, side: %1").arg(faceName(face)));
        side.setToolTip(tr("How much is cut off there; also by the handle in the image (C)"));
        grid->addWidget(new QLabel(faceName(face)), face / 2, face % 2 * 2);
        grid->addWidget(&side, face / 2, face % 2 * 2 + 1);
        connect(&side, &QDoubleSpinBox::valueChanged, this, [this, face](double mm) { typeSide(face, mm); });
    }
    return grid;
}

QLayout* CutPanel::planeButtons() {
    struct Kind {
        int axis;
        QString name, toolTip;
    };
    const std::array kinds{Kind{-1, tr("Facing"), tr("A plane that faces you, through the middle")},
                           Kind{0, tr("Sagittal"), tr("A plane between left and right")},
                           Kind{1, tr("Coronal"), tr("A plane between front and back")},
                           Kind{2, tr("Axial"), tr("A plane between head and feet")}};
    auto* grid = new QGridLayout;
    for (const Kind& kind : kinds) {
        auto* button = new QPushButton(kind.name);
        button->setToolTip(kind.toolTip);
        button->setAccessibleName(tr("Add a plane: %1").arg(kind.name));
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, [this, axis = kind.axis] { emit planeWanted(axis); });
        grid->addWidget(button, (kind.axis + 1) / 2, (kind.axis + 1) % 2);
        addPlane_.push_back(button);
    }
    return grid;
}

void CutPanel::setCuts(const Clip& clip, const std::optional<Uncut>& uncut) {
    clip_ = clip;
    uncut_ = uncut.value_or(Uncut{});
    setEnabled(uncut.has_value());
    for (int face = 0; face < 6; ++face) {
        const QSignalBlocker silent(&sides_[std::size_t(face)]);
        sides_[std::size_t(face)].setValue(uncut ? cutOffMm(clip_, uncut_, face) : 0);
    }
    showPlanes();
    for (QPushButton* button : addPlane_)
        button->setEnabled(clip.planes.size() < kMostPlanes);
    lines_.setText(tr("Freehand cuts: %1").arg(clip.freehand.size()));
    for (QWidget* part : std::initializer_list<QWidget*>{&lines_, &removeLine_})
        part->setVisible(!clip.freehand.empty());
    shadows_.setChecked(clip.shadows);
    undoAll_.setEnabled(!clip.empty());
}

/// Updates the rows of the planes. Rows are reused, so that the one being typed into stays.
void CutPanel::showPlanes() {
    const std::size_t count = uncut_ == Uncut{} ? 0 : clip_.planes.size();
    while (planes_.size() > count) {
        planes_.back()->deleteLater();
        planes_.back()->hide();
        planes_.pop_back();
    }
    while (planes_.size() < count) {
        const std::size_t number = planes_.size();
        auto* row = new PlaneRow;
        planes_.push_back(row);
        planeColumn_->addWidget(row);
        connect(row, &PlaneRow::offsetTyped, this,
                [this, number](double mm) { changePlane(number, withOffset(clip_.planes[number], uncut_, mm)); });
        connect(row, &PlaneRow::flipWanted, this, [this, number] {
            changePlane(number, {clip_.planes[number].pointMm, -clip_.planes[number].normal});
        });
        connect(row, &PlaneRow::removeWanted, this, [this, number] { removePlane(number); });
    }
    for (std::size_t i = 0; i < count; ++i)
        planes_[i]->setPlane(clip_.planes[i], uncut_);
}

void CutPanel::typeSide(int face, double mm) {
    choose(withCutOff(clip_, uncut_, face, mm));
}

void CutPanel::changePlane(std::size_t number, const ClipPlane& plane) {
    Clip clip = clip_;
    clip.planes[number] = plane;
    choose(clip);
}

void CutPanel::removePlane(std::size_t number) {
    choose(withoutCut(clip_, uncut_, {CutHandle::Kind::offset, int(number)}));
}

void CutPanel::removeLine() {
    Clip clip = clip_;
    clip.freehand.pop_back();
    choose(clip);
}

/// Requests a cut. If it equals the current one, the fields are reset: 500 mm may have been typed where 300 are left.
void CutPanel::choose(const Clip& clip) {
    if (clip == clip_)
        return setCuts(clip_, uncut_);
    emit clipChosen(clip);
}

}  // namespace pdr::ui
