#pragma once
/// The list of the series in a folder: which ones can be shown, which cannot, and why. Setters emit no signals.

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
    /// Selects the series that is shown: its index in the scan, -1 for none. The patient named above the list is always
    /// the one in the image, whatever the user has selected since.
    void setCurrent(int index);
    /// Clears the patient's name above the list; the selection stays.
    void setNothingShown();
    /// Sets the thumbnail of the series with index `series` in the scan.
    void setImage(int series, const QImage& image);
    /// Sets whether patients are numbered instead of named, e.g. for screenshots.
    void setNamesHidden(bool hidden);
    int current() const { return shown_; }
    QString patient() const { return patient_.text(); }
    /// Returns what stands for the name of the shown series' patient while names are hidden. Requires a shown series.
    QString numberedPatient() const;
    QString detail() const { return detail_.text(); }
    const QListView& list() const { return list_; }

    QSize sizeHint() const override { return {240, 400}; }

  signals:
    /// Reports a loadable series that was clicked, or selected or activated by the keyboard. Moving the focus to the
    /// list by Tab selects none.
    void seriesChosen(int index);

  private:
    void showDetail(int index);
    void name(QStandardItem& item) const;
    static QString numberedPatient(const QModelIndex& item);
    QString patientOf(const QModelIndex& item) const;
    void choose();

    int shown_ = -1;
    bool several_ = false;  ///< the list has several patients
    bool namesHidden_ = false;
    QLabel patient_;
    QListView list_;
    QStandardItemModel model_;
    QLabel detail_;
    QLabel leftOut_;
};

}  // namespace pdr::ui
