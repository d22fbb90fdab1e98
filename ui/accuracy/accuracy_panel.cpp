#include "ui/accuracy/accuracy_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>

#include "ui/text/status_text.h"

namespace pdr::ui {
namespace {

/// Adds a row with a faint heading and an empty text, which it returns.
QLabel* addFact(QGridLayout& grid, const QString& name) {
    auto* heading = new QLabel(name);
    heading->setForegroundRole(QPalette::PlaceholderText);
    auto* fact = new QLabel;
    fact->setWordWrap(true);
    fact->setTextFormat(Qt::PlainText);
    fact->setAccessibleName(name);
    const int row = grid.rowCount();
    grid.addWidget(heading, row, 0, Qt::AlignTop | Qt::AlignRight);
    grid.addWidget(fact, row, 1, Qt::AlignTop);
    return fact;
}

}  // namespace

AccuracyPanel::AccuracyPanel(QWidget* parent) : QWidget(parent), plot_(new ErrorPlot), stop_(new StopRow) {
    // Lay out the facts in a grid
    auto* facts = new QWidget;
    auto* grid = new QGridLayout(facts);
    grid->setContentsMargins(0, 0, 8, 0);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(3);
    grid->setColumnStretch(1, 1);
    auto* holdAt = new QLabel(tr("Stop at"));
    holdAt->setForegroundRole(QPalette::PlaceholderText);
    grid->addWidget(holdAt, 0, 0, Qt::AlignRight | Qt::AlignVCenter);
    grid->addWidget(stop_, 0, 1);
    comesFirst_ = addFact(*grid, {});
    comesFirst_->setAccessibleName(tr("Limit reached first"));
    noise_ = addFact(*grid, tr("Noise"));
    bias_ = addFact(*grid, tr("Systematic error"));
    health_ = addFact(*grid, tr("Invalid samples"));
    making_ = addFact(*grid, tr("Rendered on"));
    grid->setRowStretch(grid->rowCount(), 1);

    // Let them scroll where room is short
    auto* scroll = new QScrollArea;
    scroll->setWidget(facts);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::TabFocus);
    scroll->setAccessibleName(tr("Error of the image"));
    scroll->setMinimumWidth(facts->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());

    // Put them beside the plot
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 6, 4);
    row->setSpacing(12);
    row->addWidget(plot_, 3);
    row->addWidget(scroll, 2);
}

void AccuracyPanel::setAccuracy(const Accuracy& accuracy, const StopRule& rule) {
    plot_->setAccuracy(accuracy, rule.levels);
    comesFirst_->setText(accuracy.status.samplesPerPixel > 0 ? stopText(rule, accuracy) : QString());
    noise_->setText(noiseText(accuracy));
    health_->setText(healthText(accuracy.status));
}

void AccuracyPanel::setBias(const QStringList& remarks) {
    bias_->setText(remarks.join('\n'));
}

void AccuracyPanel::setMaking(const QString& making) {
    making_->setText(making);
}

void AccuracyPanel::clear() {
    setAccuracy({}, {.levels = plot_->target()});
    setBias({});
    setMaking({});
}

}  // namespace pdr::ui
