#include "ui/series/series_items.h"

#include "ui/series/series_delegate.h"
#include "ui/series/series_order.h"
#include "ui/series/series_panel.h"
#include "ui/text/room_text.h"
#include "ui/text/series_text.h"
#include "ui/text/series_words.h"

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

/// Returns a row that knows the patient of `series`.
QStandardItem* rowOf(const dicom::Series& series, int patient) {
    auto* row = new QStandardItem;
    row->setEditable(false);
    row->setData(patientName(series.patient), kPatientRole);
    row->setData(patientDetails(series.patient), kDetailsOfPatientRole);
    row->setData(patient, kNumberRole);
    return row;
}

/// Returns a heading, which neither the mouse nor the keyboard can reach. `first`: a series of the study.
QStandardItem* headingOf(const dicom::Series& first, int patient) {
    QStandardItem* row = rowOf(first, patient);
    row->setFlags(Qt::NoItemFlags);
    row->setData(-1, kSeriesRole);
    row->setData(studyText(first, false), kStudyRole);
    row->setData(studyText(first, true), kNamelessStudyRole);
    return row;
}

QStandardItem* itemOf(const dicom::Series& series, int index, int patient) {
    QStandardItem* row = rowOf(series, patient);
    row->setData(index, kSeriesRole);
    row->setData(seriesName(series), kTitleRole);
    row->setData(seriesFacts(series) << verdictText(series.verdict), kLinesRole);
    row->setData(series.verdict.loadable(), kLoadableRole);
    row->setData(detailOf(series.verdict), kDetailRole);
    row->setToolTip(detailOf(series.verdict));
    return row;
}

/// Sets the lines of a heading: the patient unless `before`, the heading above, has named the same one, and the study.
void nameHeading(QStandardItem& heading, const QStandardItem* before, bool namesHidden) {
    const bool isNew = !before || before->data(kNumberRole) != heading.data(kNumberRole);
    QStringList lines;
    if (isNew)
        lines << patientOf(heading.index(), namesHidden);
    if (isNew && !namesHidden)
        lines << heading.data(kDetailsOfPatientRole).toString();
    lines << heading.data(namesHidden ? kNamelessStudyRole : kStudyRole).toString();
    lines.removeAll({});
    heading.setData(lines.isEmpty() ? SeriesPanel::tr("Study without a date") : lines.takeFirst(), kTitleRole);
    heading.setData(lines, kLinesRole);
}

/// Returns what a screen reader says of a row. A series says whose it is, if the list has `several` patients.
QString spoken(const QStandardItem& row, bool several, bool namesHidden) {
    QStringList all;
    const bool isSeries = row.data(kSeriesRole).toInt() >= 0;
    if (isSeries && several)
        all << patientOf(row.index(), namesHidden);
    if (isSeries && several && !namesHidden)
        all << row.data(kDetailsOfPatientRole).toString();
    all << row.data(kTitleRole).toString() << row.data(kLinesRole).toStringList() << row.data(kDetailRole).toString();
    all.removeAll({});
    return all.join(", ");
}

}  // namespace

std::vector<int> fillSeriesModel(QStandardItemModel& model, const dicom::ScanResult& scan) {
    model.clear();
    std::vector<int> rows(scan.series.size());
    for (const ListedStudy& study : listedStudies(scan)) {
        model.appendRow(headingOf(scan.series[std::size_t(study.series.front())], study.patient));
        for (const int index : study.series) {
            rows[std::size_t(index)] = model.rowCount();
            model.appendRow(itemOf(scan.series[std::size_t(index)], index, study.patient));
        }
    }
    return rows;
}

void namePatients(QStandardItemModel& model, bool namesHidden) {
    const bool several = hasSeveralPatients(model);
    const QStandardItem* heading = nullptr;
    for (int i = 0; i < model.rowCount(); ++i) {
        QStandardItem& row = *model.item(i);
        if (row.data(kSeriesRole).toInt() < 0) {
            nameHeading(row, heading, namesHidden);
            heading = &row;
        }
        row.setData(spoken(row, several, namesHidden), Qt::AccessibleTextRole);
    }
}

bool hasSeveralPatients(const QStandardItemModel& model) {
    return model.rowCount() > 0 && model.item(model.rowCount() - 1)->data(kNumberRole).toInt() > 1;
}

QString patientOf(const QModelIndex& row, bool namesHidden) {
    return namesHidden ? SeriesPanel::tr("Patient %1 (name hidden)").arg(row.data(kNumberRole).toInt())
                       : row.data(kPatientRole).toString();
}

}  // namespace pdr::ui
