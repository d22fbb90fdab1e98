#pragma once
/// Paints one series of the list as three or four lines: its title, the patient where several must be told apart, its
/// facts and the verdict; beside them a thumbnail, if there is one.

#include <QStyledItemDelegate>

namespace pdr::ui {

/// The data roles of an item in the series list. The thumbnail is in Qt::DecorationRole.
/// kNumberRole  number of the patient in the list, from 1
/// kWhoRole     birth date and ID where patients must be told apart; empty: no line
enum SeriesRole {
    kPatientRole = Qt::UserRole,
    kTitleRole,
    kFactsRole,
    kVerdictRole,
    kLoadableRole,
    kDetailRole,
    kNumberRole,
    kWhoRole,
    kDetailsOfPatientRole
};

class SeriesDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace pdr::ui
