#include "ui/camera/camera_panel.h"

#include <QColorDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "render/scene/edit/camera_edits.h"
#include "ui/camera/camera_text.h"

namespace pdr::ui {
namespace {

constexpr double kSmall = 0.9;  ///< font size relative to the usual one

enum Behind { kBlack, kGrey, kWhite, kColour, kSurroundings };
const std::array<QColor, 3> kPlain{QColor(0, 0, 0), QColor(110, 110, 110), QColor(250, 250, 250)};

}  // namespace

CameraPanel::CameraPanel(QWidget* parent) : QWidget(parent) {
    describeControls();
    layOut();
    connectParts();
    showCamera();
    setBackground(kPlain[kBlack]);
}

void CameraPanel::describeControls() {
    type_.addItems({tr("Perspective"), tr("Parallel")});
    type_.setAccessibleName(tr("Projection"));
    type_.setToolTip(
        tr("Perspective: what is near is larger, as for the eye\nParallel: the same size at every depth, as "
           "for measuring"));
    const auto describe = [](QDoubleSpinBox& box, double lowest, double highest, const QString& unit,
                             const QString& name, const QString& tip) {
        box.setRange(lowest, highest);
        box.setDecimals(1);
        box.setSuffix(unit);
        box.setKeyboardTracking(false);
        box.setAccessibleName(name);
        box.setToolTip(tip);
    };
    // Describe the fields
    describe(fieldOfView_, 1, 120, tr("°"), tr("Field of view"),
             tr("From the top to the bottom of the image. What is in focus keeps its size; the wider, the nearer the "
                "eye comes"));
    describe(height_, 1, 1e5, tr(" mm"), tr("Height of what is seen"), tr("From the top to the bottom of the image"));
    describe(aperture_, 0, 200, tr(" mm"), tr("Aperture"),
             tr("Diameter of the lens. At 0 all is sharp; the larger, the less is sharp before and behind the focus"));
    // Describe focus and background
    focus_.setText(tr("Focus o&n..."));
    focus_.setCheckable(true);
    focus_.setAccessibleName(tr("Focus on what is clicked"));
    focus_.setToolTip(tr("Then click the anatomy that is to be sharp"));
    noFocus_.setText(tr("All sharp"));
    noFocus_.setToolTip(tr("A pinhole, which focuses nowhere"));
    sharp_.setWordWrap(true);
    sharp_.setAccessibleName(tr("What is sharp"));
    QFont small = sharp_.font();
    small.setPointSizeF(kSmall * small.pointSizeF());
    sharp_.setFont(small);
    behind_.addItems({tr("Black"), tr("Grey"), tr("White"), tr("Colour..."), tr("What lights it")});
    behind_.setAccessibleName(tr("Background"));
    behind_.setToolTip(tr("What stands behind the volume. A plain colour lights nothing"));
    // A click leaves the keyboard focus with the image; Tab still reaches everything.
    for (QWidget* control : std::initializer_list<QWidget*>{&type_, &focus_, &noFocus_, &behind_})
        control->setFocusPolicy(Qt::TabFocus);
}

QWidget* CameraPanel::views() {
    constexpr int kColumns = 3;
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(4);
    const std::array<QString, 6> names{tr("Front"), tr("Back"), tr("Left"), tr("Right"), tr("Head"), tr("Feet")};
    for (int i = 0; i < int(names.size()); ++i) {
        auto* button = new QPushButton(names[std::size_t(i)]);
        button->setAccessibleName(tr("View from: %1").arg(names[std::size_t(i)]));
        button->setToolTip(tr("The patient's side that one looks at (%1)").arg(i + 1));
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QPushButton::clicked, this, [this, i] { emit viewChosen(StandardView(i)); });
        grid->addWidget(button, i / kColumns, i % kColumns);
    }
    return box;
}

void CameraPanel::layOut() {
    auto* rows = new QFormLayout;
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addRow(tr("Pro&jection"), &type_);
    rows->addRow(tr("Fiel&d of view"), &fieldOfView_);
    rows->addRow(tr("Hei&ght"), &height_);
    rows->addRow(tr("Apert&ure"), &aperture_);
    auto* focus = new QHBoxLayout;
    focus->addWidget(&focus_, 1);
    focus->addWidget(&noFocus_);
    auto* last = new QFormLayout;
    last->setContentsMargins(0, 0, 0, 0);
    last->addRow(tr("Bac&kground"), &behind_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 4, 10, 8);
    column->setSpacing(6);
    column->addWidget(views());
    column->addLayout(rows);
    column->addLayout(focus);
    column->addWidget(&sharp_);
    column->addLayout(last);
    column->addStretch(1);
}

void CameraPanel::connectParts() {
    connect(&type_, &QComboBox::activated, this, [this](int index) { apply(withType(camera_, Camera::Type(index))); });
    connect(&fieldOfView_, &QDoubleSpinBox::valueChanged, this,
            [this](double degrees) { apply(withFieldOfView(camera_, degrees)); });
    connect(&height_, &QDoubleSpinBox::valueChanged, this, [this](double height) {
        Camera camera = camera_;
        camera.heightMm = height;
        apply(camera);
    });
    connect(&aperture_, &QDoubleSpinBox::valueChanged, this, [this](double aperture) {
        Camera camera = camera_;
        camera.apertureMm = aperture;
        apply(camera);
    });
    connect(&noFocus_, &QPushButton::clicked, this, [this] {
        Camera camera = camera_;
        camera.apertureMm = camera.focusMm = 0;
        apply(camera);
    });
    connect(&focus_, &QPushButton::clicked, this, &CameraPanel::pickingChosen);
    connect(&behind_, &QComboBox::activated, this, &CameraPanel::chooseBackground);
}

void CameraPanel::setCamera(const Camera& camera) {
    camera_ = camera;
    showCamera();
}

void CameraPanel::showCamera() {
    const QSignalBlocker fieldOfView(&fieldOfView_), height(&height_), aperture(&aperture_);
    const bool perspective = camera_.type == Camera::Type::perspective;
    type_.setCurrentIndex(int(camera_.type));
    fieldOfView_.setValue(camera_.fovDegrees);
    fieldOfView_.setEnabled(perspective);
    height_.setValue(camera_.heightInFocusMm());
    height_.setEnabled(!perspective);
    aperture_.setValue(camera_.apertureMm);
    noFocus_.setEnabled(camera_.apertureMm > 0);
    sharp_.setText(sharpText(camera_));
}

void CameraPanel::setBackground(const std::optional<QColor>& colour) {
    background_ = colour;
    const auto plain = colour ? std::find(kPlain.begin(), kPlain.end(), *colour) : kPlain.end();
    const int index = !colour ? int(kSurroundings) : plain == kPlain.end() ? int(kColour) : int(plain - kPlain.begin());
    behind_.setCurrentIndex(index);
}

void CameraPanel::setPicking(bool picking) {
    focus_.setChecked(picking);
}

void CameraPanel::chooseBackground(int index) {
    if (index == kColour)
        return askForColour();
    const auto colour = index == kSurroundings ? std::nullopt : std::optional(kPlain[std::size_t(index)]);
    setBackground(colour);
    emit backgroundChosen(colour);
}

void CameraPanel::askForColour() {
    const QColor colour = QColorDialog::getColor(background_.value_or(kPlain[kGrey]), this, tr("Background"));
    if (colour.isValid())
        background_ = colour;
    setBackground(background_);
    if (colour.isValid())
        emit backgroundChosen(colour);
}

void CameraPanel::apply(const Camera& camera) {
    camera_ = camera;
    showCamera();
    emit cameraEdited(camera_);
}

}  // namespace pdr::ui
