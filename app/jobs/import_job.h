#pragma once
/// Reading a folder and a series beside the window.

#include <chrono>
#include <filesystem>
#include <memory>

#include "app/jobs/background_job.h"
#include "app/scan/hidden_voxels.h"
#include "dicom/series.h"
#include "render/segment/findings.h"
#include "render/segment/hidden_table.h"

namespace pdr::app {

class ImportJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// `patience`: how long a series waits for the one before to be let go of, before it is refused.
    explicit ImportJob(std::chrono::milliseconds patience = std::chrono::minutes(1)) : patience_(patience) {}

    /// The scan that the signals' indices refer to.
    const dicom::ScanResult& scan() const { return scan_; }
    /// What is to be known of the series that was loaded last and of how its voxels were read.
    const std::vector<dicom::Note>& loadNotes() const { return loadNotes_; }

  public slots:
    /// Reads the headers in `folder`; ends with scanned() or failed().
    void scanFolder(const QString& folder);
    /// Reads the pixels of a loadable series of the last scan, and looks for the scanner's table in them; ends with
    /// loaded() or failed(). Begins when the volume that was loaded last has been let go of by all who held it: memory
    /// may not have room for two. Those are told by Document::closing().
    void loadSeries(int index);

  signals:
    void scanned(const pdr::dicom::ScanResult& scan, const QString& folder);
    /// `volume`: the scan without its `table`, what the patient lies on. `findings`: of that volume. `hidden`: the
    /// voxels that it lacks; null where these are none.
    void loaded(std::shared_ptr<const pdr::Volume> volume, int index, const pdr::segment::HiddenTable& table,
                const pdr::segment::Findings& findings, std::shared_ptr<const pdr::app::HiddenVoxels> hidden);

  private:
    std::chrono::milliseconds patience_;
    dicom::ScanResult scan_;
    std::vector<dicom::Note> loadNotes_;
    std::weak_ptr<const Volume> lastLoaded_;  ///< without its table
};

}  // namespace pdr::app
