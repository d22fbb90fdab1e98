#pragma once
/// Paints one series as three lines: its name, its facts, its verdict.

#include <QStyledItemDelegate>

namespace pdr::ui {

/// What an item of the series list holds.
/// kNumberRole: of the patient in the list, from 1.
enum SeriesRole {
    kPatientRole = Qt::UserRole,
    kTitleRole,
    kFactsRole,
    kVerdictRole,
    kLoadableRole,
    kDetailRole,
    kNumberRole
};

class SeriesDelegate : public QStyledItemDelegate {
    Q_OBJECT

  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace pdr::ui
