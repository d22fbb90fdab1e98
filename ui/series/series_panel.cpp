#include "ui/series/series_panel.h"

#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/series/series_delegate.h"
#include "ui/text/room_text.h"
#include "ui/text/series_text.h"
#include "ui/text/to_qt.h"

namespace pdr::ui {
namespace {

/// Returns the reason why a series cannot be shown, or remarks about one that can.
QString detailOf(const dicom::GeometryVerdict& verdict) {
    QStringList lines;
    if (!verdict.reason.empty())
        lines << sentence(verdict.reason);
    for (const dicom::Note& note : verdict.notes)
        lines << sentence(note.text);
    return lines.join('\n');
}

bool samePatient(const dicom::Series& a, const dicom::Series& b) {
    return dicom::samePatient(a.patient, b.patient);
}

/// Returns the number of the series' patient, from 1, in the order of the list.
int patientNumber(const dicom::ScanResult& scan, const dicom::Series& series) {
    int number = 0;
    for (auto one = scan.series.begin(); one != scan.series.end(); ++one) {
        const bool isNew = std::none_of(scan.series.begin(), one, [&](const auto& s) { return samePatient(s, *one); });
        number += isNew ? 1 : 0;
        if (samePatient(*one, series))
            break;
    }
    return number;
}

QStandardItem* itemOf(const dicom::Series& series, int patientNumber) {
    const QString title = seriesTitle(series), facts = seriesFacts(series), date = seriesDate(series);
    const QString verdict = verdictText(series.verdict) + (date.isEmpty() ? "" : ", " + date);
    auto* item = new QStandardItem(title);
    item->setEditable(false);
    item->setData(patientName(series.patient), kPatientRole);
    item->setData(patientDetails(series.patient), kDetailsOfPatientRole);
    item->setData(patientNumber, kNumberRole);
    item->setData(facts, kFactsRole);
    item->setData(verdict, kVerdictRole);
    item->setData(series.verdict.loadable(), kLoadableRole);
    item->setData(detailOf(series.verdict), kDetailRole);
    item->setToolTip(detailOf(series.verdict));
    return item;
}

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

    list_.setAccessibleName(tr("Series"));
    list_.setModel(&model_);
    list_.setItemDelegate(new SeriesDelegate(&list_));
    list_.setFrameShape(QFrame::NoFrame);
    list_.setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    list_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(list_.selectionModel(), &QItemSelectionModel::selectionChanged, this, &SeriesPanel::choose);
    connect(&list_, &QListView::activated, list_.selectionModel(), [this](const QModelIndex& item) {
        list_.selectionModel()->select(item, QItemSelectionModel::ClearAndSelect);
    });

    for (QLabel* label : {&detail_, &leftOut_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->hide();
    }
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
    model_.clear();
    several_ = std::any_of(scan.series.begin(), scan.series.end(),
                           [&](const dicom::Series& series) { return !samePatient(series, scan.series.front()); });
    for (const dicom::Series& series : scan.series) {
        model_.appendRow(itemOf(series, patientNumber(scan, series)));
        name(*model_.item(model_.rowCount() - 1));
    }
    setCurrent(-1);
    leftOut_.setVisible(!scan.problems.empty());
    leftOut_.setText(QString::fromUtf8("\u26A0  ") +
                     (scan.problems.size() == 1 ? tr("1 damaged file was left out")
                                                : tr("%1 damaged files were left out").arg(scan.problems.size())));
    leftOut_.setToolTip(fileNames(scan.problems));
}

void SeriesPanel::setCurrent(int index) {
    const QSignalBlocker silent(this);
    shown_ = index;
    const QModelIndex item = model_.index(index, 0);
    patient_.setText(item.isValid() ? patientOf(item) : QString());
    list_.selectionModel()->setCurrentIndex(item, QItemSelectionModel::ClearAndSelect);
    showDetail(index);
}

void SeriesPanel::setImage(int series, const QImage& image) {
    if (QStandardItem* item = model_.item(series))
        item->setData(QPixmap::fromImage(image), Qt::DecorationRole);
}

void SeriesPanel::setNothingShown() {
    shown_ = -1;
    patient_.clear();
}

void SeriesPanel::setNamesHidden(bool hidden) {
    namesHidden_ = hidden;
    for (int i = 0; i < model_.rowCount(); ++i)
        name(*model_.item(i));
    if (shown_ >= 0)
        patient_.setText(patientOf(model_.index(shown_, 0)));
}

QString SeriesPanel::numberedPatient() const {
    return numberedPatient(model_.index(shown_, 0));
}

QString SeriesPanel::numberedPatient(const QModelIndex& item) {
    return tr("Patient %1 (name hidden)").arg(item.data(kNumberRole).toInt());
}

QString SeriesPanel::patientOf(const QModelIndex& item) const {
    return namesHidden_ ? numberedPatient(item) : item.data(kPatientRole).toString();
}

/// Sets the title of the item, preceded by the patient if the list has several.
void SeriesPanel::name(QStandardItem& item) const {
    const QString series = item.text();
    const QString title = several_ ? tr("%1: %2", "patient, series").arg(patientOf(item.index()), series) : series;
    item.setData(title, kTitleRole);
    item.setData(several_ && !namesHidden_ ? item.data(kDetailsOfPatientRole) : QVariant(), kWhoRole);
    QStringList all{title};
    for (const int role : {kWhoRole, kFactsRole, kVerdictRole, kDetailRole})
        all << item.data(role).toString();
    all.removeAll({});
    item.setData(all.join(", "), Qt::AccessibleTextRole);
}

void SeriesPanel::showDetail(int index) {
    const QString text = model_.index(index, 0).data(kDetailRole).toString();
    detail_.setText(text);
    detail_.setVisible(!text.isEmpty());
}

void SeriesPanel::choose() {
    const QModelIndexList marked = list_.selectionModel()->selectedIndexes();
    if (marked.isEmpty())
        return;
    const QModelIndex& item = marked.front();
    showDetail(item.row());
    if (item.data(kLoadableRole).toBool())
        emit seriesChosen(item.row());
}

}  // namespace pdr::ui
