#pragma once
/// Paints the rows of the series list: headings of patients and studies, and below each its series: a title, lines of
/// facts and the verdict; beside them a thumbnail, if there is one.

#include <QStyledItemDelegate>

namespace pdr::ui {

/// The data roles of a row of the series list. The thumbnail is in Qt::DecorationRole.
///   kSeriesRole            index of the series in the scan; -1: the row is a heading
///   kTitleRole, kLinesRole the first line, and those below it (QStringList)
///   kLoadableRole          whether the series can be loaded
///   kDetailRole            the reason of a refusal, or notes, as sentences
///   kPatientRole, kDetailsOfPatientRole, kNumberRole   the patient's name; birth date and ID; number in the list
///   kStudyRole, kNamelessStudyRole                     the study of a heading, and without what may name the patient
enum SeriesRole {
    kPatientRole = Qt::UserRole,
    kDetailsOfPatientRole,
    kNumberRole,
    kStudyRole,
    kNamelessStudyRole,
    kSeriesRole,
    kTitleRole,
    kLinesRole,
    kLoadableRole,
    kDetailRole,
};

class SeriesDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace pdr::ui
