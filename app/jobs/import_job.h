#pragma once
/// Reads a folder of DICOM files, and a series of it, in the background.

#include <chrono>
#include <filesystem>
#include <memory>

#include "app/jobs/background_job.h"
#include "app/scan/hidden_voxels.h"
#include "dicom/series.h"
#include "render/segment/findings.h"
#include "render/segment/hidden_table.h"
#include "render/volume/arriving_volume.h"

namespace pdr::app {

class ImportJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// `patience`: how long a series waits for the previous volume to be released, before it is refused.
    explicit ImportJob(std::chrono::milliseconds patience = std::chrono::minutes(1)) : patience_(patience) {}

    /// The result of the last scan, to which the signals' indices refer.
    const dicom::ScanResult& scan() const { return scan_; }
    /// Notes on the series that was loaded last and on how its voxels were read.
    const std::vector<dicom::Note>& loadNotes() const { return loadNotes_; }

  public slots:
    /// Reads the headers in `folder`; ends with scanned() or failed().
    void scanFolder(const QString& folder);
    /// Reads the pixels of a loadable series of the last scan, and looks for the scanner's table in them; ends with
    /// loaded() or failed(). Begins when all holders have released the volume that was loaded last, since there may not
    /// be memory for two. Document::closing() notifies the holders.
    void loadSeries(int index);

  signals:
    void scanned(const pdr::dicom::ScanResult& scan, const QString& folder);
    /// `volume`: what loadSeries() reads series `index` into. Its slices can be looked at until the job ends. Not
    /// emitted if the slices have to be resampled, or lie in a volume file.
    void arriving(std::shared_ptr<const pdr::ArrivingVolume> volume, int index);
    /// `volume`: the scan without its `table`, on which the patient lies. `findings`: what that volume holds. `hidden`:
    /// the voxels that it lacks; null if there are none.
    void loaded(std::shared_ptr<const pdr::Volume> volume, int index, const pdr::segment::HiddenTable& table,
                const pdr::segment::Findings& findings, std::shared_ptr<const pdr::app::HiddenVoxels> hidden);

  private:
    std::chrono::milliseconds patience_;
    dicom::ScanResult scan_;
    std::vector<dicom::Note> loadNotes_;
    std::weak_ptr<const Volume> lastLoaded_;  ///< the volume without its table
};

}  // namespace pdr::app
