#pragma once
/// Opening a scan: the list of a folder's series, the start panel, recent folders, and what the window says of the open
/// series and its patient.

#include "app/jobs/import_job.h"
#include "app/jobs/series_images.h"
#include "app/presenters/presenter.h"
#include "ui/series/series_panel.h"

namespace pdr::app {

class SeriesPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit SeriesPresenter(const Workspace& workspace);

    /// Reads `folder` and lists its series; if only one can be shown, it is shown. Asks before unsaved work is lost.
    void open(const QString& folder);
    /// Closes the series and shows the window in which nothing is open.
    void close();
    const ImportJob& import() const { return import_; }
    /// Returns the series whose volume is open; null if none is.
    const dicom::Series* series() const;

    bool cancelJob() override { return cancel(import_); }

  private:
    void connectWindow();
    void connectImport();
    void showScan(const dicom::ScanResult& scan, const QString& folder);
    void showChoice(const dicom::ScanResult& scan, const QString& folder);
    void showRecentFolders();
    void load(int index);
    void showArriving(std::shared_ptr<const ArrivingVolume> volume, int index);
    void showSubject(int index);
    void showVolume(std::shared_ptr<const Volume> volume, int index, const segment::HiddenTable& table,
                    const segment::Findings& findings, std::shared_ptr<const HiddenVoxels> hidden);
    void showProgress(double fraction, const QString& step);
    void showEnd();
    void showOthersLeftOut();

    ui::SeriesPanel* panel_;
    ImportJob import_;
    SeriesImages images_;
    int shown_ = -1;  ///< index of the series whose volume is open; -1: none
};

}  // namespace pdr::app
