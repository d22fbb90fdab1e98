#pragma once
/// Small pictures of the series of a folder, by which they are told apart before one is chosen. In memory alone.

#include <QImage>

#include "app/jobs/background_job.h"
#include "dicom/series.h"

namespace pdr::app {

class SeriesPictures : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Reads the middle slice of each series that can be loaded. One that cannot be read has no picture.
    void make(const pdr::dicom::ScanResult& scan);

  signals:
    /// The middle slice of the series with index `series` in the scan.
    void made(int series, const QImage& picture);
};

/// The middle slice of `series`, which can be loaded, seen from the feet with the first row above, in its true shape
/// and at most 96 pixels long. Null: it cannot be read.
QImage seriesPicture(const dicom::Series& series);

}  // namespace pdr::app
