#include "ui/window/start_panel.h"

#include <QDir>
#include <algorithm>

namespace pdr::ui {
namespace {

constexpr int kWidth = 420, kMargin = 24;  ///< width of the panel, and what its frame leaves free on each side [px]
constexpr qsizetype kMostShown = 4;        ///< recent folders and plans shown on the panel, each

/// Returns the last two parts of a path, e.g. "study/series 3": usually enough to tell folders apart.
QString shortName(const QString& path) {
    const QStringList parts = QDir::cleanPath(path).split('/', Qt::SkipEmptyParts);
    return parts.mid(std::max<qsizetype>(parts.size() - 2, 0)).join('/').replace('&', "&&");
}

QLabel* quiet(const QString& text) {
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setWordWrap(true);
    return label;
}

}  // namespace

StartPanel::StartPanel(QWidget* parent) : QFrame(parent) {
    setObjectName("start");  // by which the style sheet draws it
    setFixedWidth(kWidth);
    open_.setText(tr("&Open a folder..."));
    open_.setAccessibleName(tr("Open a folder"));
    connect(&open_, &QPushButton::clicked, this, &StartPanel::openRequested);
    example_.setText(tr("Open the e&xample"));
    example_.setAccessibleName(tr("Open the example"));
    example_.setToolTip(tr("Sample CT (included)"));
    example_.hide();
    connect(&example_, &QPushButton::clicked, this, [this] { emit folderChosen(exampleFolder_); });
    head(plans_, tr("Recent plans"));
    head(folders_, tr("Recently opened"));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->setSpacing(10);
    auto* ways = new QHBoxLayout;
    ways->addWidget(&open_, 1);
    ways->addWidget(&example_, 1);
    column->addLayout(ways);
    column->addWidget(&plans_.box);
    column->addWidget(&folders_.box);
    column->addWidget(quiet(tr("What can be dropped on the window:")));
    for (const QString& what : {tr("a folder of DICOM files, or one of the files: its series are listed"),
                                tr("a ZIP archive of DICOM or volume files, or one volume: NIfTI, NRRD or MetaImage"),
                                tr("a plan (.plan.json), once its scan is open"),
                                tr("an OpenEXR environment image, which then lights the scan")})
        column->addWidget(quiet(QString(QChar(0x2022)) + ' ' + what));
}

void StartPanel::head(Recent& recent, const QString& heading) {
    recent.column = new QVBoxLayout(&recent.box);
    recent.column->setContentsMargins(0, 8, 0, 0);
    recent.column->setSpacing(4);
    recent.column->addWidget(quiet(heading));
    recent.box.hide();
}

void StartPanel::fill(Recent& recent, const QStringList& paths, void (StartPanel::*chosen)(const QString&)) {
    qDeleteAll(recent.box.findChildren<QPushButton*>());
    for (const QString& path : paths.mid(0, kMostShown)) {
        constexpr int kText = kWidth - 2 * kMargin - 20;
        auto* button = new QPushButton(fontMetrics().elidedText(shortName(path), Qt::ElideMiddle, kText));
        button->setAccessibleName(tr("Open %1").arg(path));
        button->setToolTip(path);
        button->setProperty("narrow", true);
        connect(button, &QPushButton::clicked, this, [this, path, chosen] { emit(this->*chosen)(path); });
        recent.column->addWidget(button);
    }
    recent.box.setVisible(!paths.isEmpty());
    adjustSize();
}

void StartPanel::setRecent(const QStringList& folders) {
    fill(folders_, folders, &StartPanel::folderChosen);
}

void StartPanel::setRecentPlans(const QStringList& files) {
    fill(plans_, files, &StartPanel::planChosen);
}

void StartPanel::setExample(const QString& folder) {
    exampleFolder_ = folder;
    example_.setVisible(!folder.isEmpty());
}

}  // namespace pdr::ui
