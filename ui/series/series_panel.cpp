#include "ui/series/series_panel.h"

#include <QKeyEvent>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/series/series_delegate.h"
#include "ui/series/series_items.h"
#include "ui/text/room_text.h"
#include "ui/text/to_qt.h"

namespace pdr::ui {
namespace {

QString fileNames(const std::vector<dicom::Problem>& problems) {
    constexpr std::size_t kAtMost = 20;
    QStringList lines;
    for (std::size_t i = 0; i < std::min(problems.size(), kAtMost); ++i)
        lines << toQt(problems[i].file.filename()) + ": " + inWords(problems[i].reason);
    if (problems.size() > kAtMost)
        lines << SeriesPanel::tr("and %n more", nullptr, int(problems.size() - kAtMost));
    return lines.join('\n');
}

}  // namespace

SeriesPanel::SeriesPanel(QWidget* parent) : QWidget(parent) {
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.15);
    patient_.setFont(large);
    patient_.setAccessibleName(tr("Patient"));
    patient_.setTextFormat(Qt::PlainText);
    patient_.setWordWrap(true);

    list_.setObjectName("seriesList");
    list_.setAccessibleName(tr("Series"));
    list_.setModel(&model_);
    list_.setItemDelegate(new SeriesDelegate(&list_));
    list_.setFrameShape(QFrame::NoFrame);
    list_.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_.installEventFilter(this);
    connect(list_.selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
        const QModelIndexList marked = list_.selectionModel()->selectedIndexes();
        showDetail(marked.isEmpty() ? QModelIndex() : marked.front());
    });
    connect(&list_, &QListView::clicked, this, &SeriesPanel::choose);
    connect(&list_, &QListView::activated, this, &SeriesPanel::choose);

    for (QLabel* label : {&detail_, &leftOut_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->hide();
    }
    detail_.setObjectName("seriesDetail");
    detail_.setAccessibleName(tr("About the series"));
    leftOut_.setAccessibleName(tr("Files that were left out"));
    leftOut_.setForegroundRole(QPalette::PlaceholderText);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 8, 10, 10);
    column->setSpacing(8);
    column->addWidget(&patient_);
    column->addWidget(&list_, 1);
    column->addWidget(&detail_);
    column->addWidget(&leftOut_);
}

void SeriesPanel::setScan(const dicom::ScanResult& scan) {
    const QSignalBlocker silent(this);
    rows_ = fillSeriesModel(model_, scan);
    namePatients(model_, namesHidden_);
    setCurrent(-1);
    leftOut_.setVisible(!scan.problems.empty());
    leftOut_.setText(QString::fromUtf8("\u26A0  ") +
                     (scan.problems.size() == 1 ? tr("1 damaged file was left out")
                                                : tr("%1 damaged files were left out").arg(scan.problems.size())));
    leftOut_.setToolTip(fileNames(scan.problems));
}

std::vector<int> SeriesPanel::order() const {
    std::vector<int> all;
    for (int i = 0; i < model_.rowCount(); ++i)
        if (const int series = model_.item(i)->data(kSeriesRole).toInt(); series >= 0)
            all.push_back(series);
    return all;
}

QModelIndex SeriesPanel::rowOf(int series) const {
    return series < 0 || series >= int(rows_.size()) ? QModelIndex() : model_.index(rows_[std::size_t(series)], 0);
}

void SeriesPanel::setCurrent(int index) {
    const QSignalBlocker silent(this);
    shown_ = chosen_ = index;
    const QModelIndex row = rowOf(index);
    showPatient();
    list_.selectionModel()->setCurrentIndex(row, QItemSelectionModel::ClearAndSelect);
    showDetail(row);
}

void SeriesPanel::setImage(int series, const QImage& image) {
    if (QStandardItem* item = model_.itemFromIndex(rowOf(series)))
        item->setData(QPixmap::fromImage(image), Qt::DecorationRole);
}

void SeriesPanel::setNothingShown() {
    shown_ = -1;
    showPatient();
}

void SeriesPanel::setNamesHidden(bool hidden) {
    namesHidden_ = hidden;
    namePatients(model_, hidden);
    showPatient();
}

QString SeriesPanel::numberedPatient() const {
    return patientOf(rowOf(shown_), true);
}

bool SeriesPanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() != QEvent::KeyPress || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Space)
        return QWidget::eventFilter(watched, event);
    list_.selectionModel()->select(list_.currentIndex(), QItemSelectionModel::ClearAndSelect);
    choose(list_.currentIndex());
    return true;
}

/// Names the patient in the image above the list. With one patient in it, the heading says the same.
void SeriesPanel::showPatient() {
    const QModelIndex row = rowOf(shown_);
    patient_.setText(row.isValid() ? patientOf(row, namesHidden_) : QString());
    patient_.setVisible(row.isValid() && hasSeveralPatients(model_));
}

void SeriesPanel::showDetail(const QModelIndex& row) {
    const QString text = row.data(kDetailRole).toString();
    detail_.setText(text);
    detail_.setVisible(!text.isEmpty());
}

void SeriesPanel::choose(const QModelIndex& row) {
    const int series = row.isValid() ? row.data(kSeriesRole).toInt() : -1;
    if (series < 0 || series == chosen_ || !row.data(kLoadableRole).toBool())
        return;
    chosen_ = series;
    emit seriesChosen(series);
}

}  // namespace pdr::ui
