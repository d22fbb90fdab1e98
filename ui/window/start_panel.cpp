#include "ui/window/start_panel.h"

#include <QDir>
#include <QLabel>

namespace pdr::ui {
namespace {

/// Returns the last two parts of a path, e.g. "study/series 3": usually enough to tell folders apart.
QString shortName(const QString& folder) {
    const QStringList parts = QDir::cleanPath(folder).split('/', Qt::SkipEmptyParts);
    return parts.mid(std::max<qsizetype>(parts.size() - 2, 0)).join('/').replace('&', "&&");
}

}  // namespace

StartPanel::StartPanel(QWidget* parent) : QFrame(parent), recentColumn_(new QVBoxLayout(&recent_)) {
    constexpr int kWidth = 380, kMargin = 24;
    setObjectName("start");  // by which the style sheet draws it
    setFixedWidth(kWidth);
    // Add the ways to open a folder
    open_.setText(tr("&Open a folder..."));
    open_.setAccessibleName(tr("Open a folder"));
    connect(&open_, &QPushButton::clicked, this, &StartPanel::openRequested);
    example_.setText(tr("Open the e&xample"));
    example_.setAccessibleName(tr("Open the example"));
    example_.setToolTip(tr("Sample CT (included)"));
    example_.hide();
    connect(&example_, &QPushButton::clicked, this, [this] { emit folderChosen(exampleFolder_); });
    auto* hint = new QLabel(tr("Or drop a DICOM folder, or one of its files, here: its CT series are listed."));
    hint->setWordWrap(true);
    auto* heading = new QLabel(tr("Recently opened"));
    heading->setForegroundRole(QPalette::PlaceholderText);
    recentColumn_->setContentsMargins(0, 8, 0, 0);
    recentColumn_->addWidget(heading);
    recent_.hide();

    // Lay them out in a column
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    column->setSpacing(10);
    column->addWidget(&open_);
    column->addWidget(&example_);
    column->addWidget(hint);
    column->addWidget(&recent_);
}

void StartPanel::setRecent(const QStringList& folders) {
    qDeleteAll(recent_.findChildren<QPushButton*>());
    for (const QString& folder : folders) {
        auto* button = new QPushButton(shortName(folder));
        button->setAccessibleName(tr("Open %1").arg(folder));
        button->setToolTip(folder);
        connect(button, &QPushButton::clicked, this, [this, folder] { emit folderChosen(folder); });
        recentColumn_->addWidget(button);
    }
    recent_.setVisible(!folders.isEmpty());
    adjustSize();
}

void StartPanel::setExample(const QString& folder) {
    exampleFolder_ = folder;
    example_.setVisible(!folder.isEmpty());
}

}  // namespace pdr::ui
