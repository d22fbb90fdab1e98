#pragma once
/// Paints one series as three or four lines beside a small picture of it, if there is one: its name, whose it is where
/// that must be told, its facts, its verdict.

#include <QStyledItemDelegate>

namespace pdr::ui {

/// What an item of the series list holds.
/// kNumberRole: of the patient in the list, from 1. kWhoRole: birth date and ID where patients must be told apart;
/// empty: no line. The picture is in Qt::DecorationRole.
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
