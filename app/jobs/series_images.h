#pragma once
/// Makes small images of the series of a folder, by which the user tells them apart before choosing one. They stay in
/// memory and are not written to disk.

#include <QImage>
#include <stop_token>
#include <vector>

#include "app/jobs/background_job.h"
#include "dicom/series.h"

namespace pdr::app {

class SeriesImages : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Reads the middle slice of the series with these indices in `scan`, one after the other, and emits made() as soon
    /// as it has one. A series that cannot be read gets no image.
    void make(const pdr::dicom::ScanResult& scan, const std::vector<int>& order);

  signals:
    /// Reports the middle slice of the series with index `series` in the scan.
    void made(int series, const QImage& image);
};

/// Returns the middle slice of `series` through the window that its files ask for, else one for soft tissue and bone:
/// in its true shape and at most 96 pixels long. Where the grid is known, the patient's left, back and feet are right
/// or below, as radiologists see slices. Null if it cannot be read, or after a stop.
QImage seriesImage(const dicom::Series& series, const std::stop_token& stop = {});

}  // namespace pdr::app
