#pragma once
/// The series of a folder, with what can be shown and what not, and why. Setters are silent.

#include <QImage>
#include <QLabel>
#include <QListView>
#include <QStandardItemModel>
#include <QWidget>

#include "dicom/series.h"

namespace pdr::ui {

class SeriesPanel : public QWidget {
    Q_OBJECT

  public:
    explicit SeriesPanel(QWidget* parent = nullptr);

    void setScan(const dicom::ScanResult& scan);
    /// Marks the series that is shown: its place in the scan, -1 for none. The patient named above the list is always
    /// the one in the picture, whatever the user has marked since.
    void setCurrent(int index);
    /// No patient is named, and what the user has marked stays marked.
    void setNothingShown();
    /// A small picture of the series at that place of the scan.
    void setPicture(int series, const QImage& picture);
    /// For screenshots: patients are numbered in the place of their names.
    void setNamesHidden(bool hidden);
    int current() const { return shown_; }
    QString patient() const { return patient_.text(); }
    QString detail() const { return detail_.text(); }
    const QListView& list() const { return list_; }

    QSize sizeHint() const override { return {240, 400}; }

  signals:
    /// A loadable series was clicked, or marked or taken by the keyboard; to reach the list by Tab marks none.
    void seriesChosen(int index);

  private:
    void showDetail(int index);
    void name(QStandardItem& item) const;
    QString patientOf(const QModelIndex& item) const;
    void choose();

    int shown_ = -1;
    bool several_ = false;  ///< patients
    bool namesHidden_ = false;
    QLabel patient_;
    QListView list_;
    QStandardItemModel model_;
    QLabel detail_;
    QLabel leftOut_;
};

}  // namespace pdr::ui
