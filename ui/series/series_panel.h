#pragma once
/// The list of the series in a folder, by patient and study: which ones can be shown, which cannot, and why. Setters
/// emit no signals. Series are named by their index in the scan, whatever row they have.

#include <QImage>
#include <QLabel>
#include <QListView>
#include <QStandardItemModel>
#include <QWidget>
#include <vector>

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
    /// Returns the indices of the series in the scan, in the order of the list.
    std::vector<int> order() const;
    /// Returns the row of the series with index `series` in the scan.
    QModelIndex rowOf(int series) const;

    QSize sizeHint() const override { return {240, 400}; }

  signals:
    /// Reports a loadable series that was clicked, or chosen by Enter or the space bar. The arrow keys only mark one
    /// and show what is said about it.
    void seriesChosen(int index);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void showDetail(const QModelIndex& row);
    void showPatient();
    void choose(const QModelIndex& row);

    int shown_ = -1;
    int chosen_ = -1;  ///< what was asked for last; a double click asks once
    bool namesHidden_ = false;
    std::vector<int> rows_;  ///< the row of each series, by its index in the scan
    QLabel patient_;
    QListView list_;
    QStandardItemModel model_;
    QLabel detail_;
    QLabel leftOut_;
};

}  // namespace pdr::ui
