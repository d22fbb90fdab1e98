#pragma once
/// Reading a folder and a series beside the window.

#include <array>
#include <filesystem>
#include <memory>

#include "app/background_job.h"
#include "dicom/series.h"
#include "render/segment/findings.h"
#include "render/segment/hidden_table.h"

namespace pdr::app {

class ImportJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// The scan that the signals' indices refer to.
    const dicom::ScanResult& scan() const { return scan_; }
    /// What only the pixels of the series that was loaded last could tell.
    const std::vector<dicom::Note>& loadNotes() const { return loadNotes_; }

  public slots:
    /// Reads the headers in `folder`; ends with scanned() or failed().
    void scanFolder(const QString& folder);
    /// Reads the pixels of a loadable series of the last scan, and looks for the scanner's table in them; ends with
    /// loaded() or failed(). Begins when the volume that was loaded last has been let go of by all who held it: memory
    /// may not have room for two.
    void loadSeries(int index);

  signals:
    void scanned(const pdr::dicom::ScanResult& scan, const QString& folder);
    /// `table`: what the patient lies on, and the scan without it. `findings`: of that.
    void loaded(std::shared_ptr<const pdr::Volume> volume, int index, const pdr::segment::HiddenTable& table,
                const pdr::segment::Findings& findings);

  private:
    dicom::ScanResult scan_;
    std::vector<dicom::Note> loadNotes_;
    std::array<std::weak_ptr<const Volume>, 2> lastLoaded_;  ///< the scan, and that without a table
};

}  // namespace pdr::app
