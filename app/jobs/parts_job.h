#pragma once
/// Parts of a scan: reads label maps, and finds parts in the scan itself, in the background.

#include <QString>
#include <memory>
#include <optional>

#include "app/jobs/background_job.h"
#include "app/plan/part_maps.h"
#include "dicom/series.h"
#include "render/volume/label_fit.h"
#include "render/volume/volume.h"

namespace pdr::app {

class PartsJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// The scan whose parts are wanted, and the series that it was read from.
    struct Scan {
        std::shared_ptr<const Volume> volume;
        std::optional<dicom::Series> series;
    };

    PartsJob();
    /// Reads the label map in a file or a folder of masks, in place of the one before, beside the rules' parts of
    /// `sources`; ends with added(), resamplingWanted(), failed() or cancelled().
    void open(const Scan& scan, const QString& file, Resampling resampling, const PartSources& sources);
    /// Finds parts in the scan, beside those of `sources`; ends with added(), failed() or cancelled().
    void find(const Scan& scan, PartRule rule, const PartSources& sources);
    /// Makes the parts of `sources`; ends with made(), labelsMissing(), failed() or cancelled(). A job that does so
    /// already goes on.
    void make(const Scan& scan, const PartSources& sources);
    /// Cancels, and releases all parts.
    void forget();

  signals:
    void added(const pdr::app::PartSources& sources, const std::shared_ptr<const pdr::app::ScanParts>& parts);
    void made(const pdr::app::PartSources& sources, const std::shared_ptr<const pdr::app::ScanParts>& parts);
    /// Emitted if the label map in `file` has other voxels than the scan, as `error` says, and fits it otherwise.
    void resamplingWanted(const QString& file, const pdr::Error& error);
    /// Emitted if `sources` have a label map that is not the one that was read last.
    void labelsMissing(const pdr::app::PartSources& sources);

  private:
    std::shared_ptr<PartMaps> maps_;     ///< used on the job's thread alone
    std::optional<PartSources> making_;  ///< what the newest job makes; none: it adds parts
};

}  // namespace pdr::app
