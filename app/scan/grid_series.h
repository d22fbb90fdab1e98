#pragma once
/// Volume files (NIfTI, NRRD, MetaImage) as series: each is one entry, judged by the importer's own rules for slices,
/// so that list, report and rendering treat it as they treat DICOM. Left-handed grids are turned by the order of their
/// slices, which moves no voxel.

#include <filesystem>
#include <stop_token>
#include <vector>

#include "app/scan/grid_unit.h"
#include "dicom/read/pixels.h"
#include "dicom/series.h"
#include "dicom/series_source.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/file/grid_file.h"

namespace pdr::app {

/// The source of a series that lies in a volume file. Its only object is that file, and the frame of a slice is its
/// index k in the file.
class GridSource : public dicom::SeriesSource {
  public:
    explicit GridSource(GridFile grid) : grid_(std::move(grid)) {}

    std::filesystem::path root() const override { return grid_.file.parent_path(); }
    Result<Listing> list(const Progress&) const override { return Listing{{grid_.file}, {}}; }
    Result<NamedBytes> open(const std::filesystem::path& name) const override { return NamedBytes{name}; }
    const GridFile& grid() const { return grid_; }

  private:
    GridFile grid_;
};

/// Reads the header of `file` and, for the range of its values, all samples; memory is taken for none, but for what
/// `open` takes. The series says that the file states no unit, with the range, or why it is refused. Errors: those of
/// readGridFile() and GridSamples; cancelled().
Result<dicom::Series> gridSeries(const std::filesystem::path& file, const Progress& progress,
                                 const OpenBytes& open = onDisk);

/// Reads the voxels of `series`, which comes from gridSeries() and must be loadable. What is not a number becomes
/// padding. Errors: those of GridSamples; the file is not the one that was listed; not enough memory; cancelled().
Result<Volume> loadGridSeries(const dicom::Series& series, const Progress& progress);

/// Reads one slice of `series`, which comes from gridSeries(), and all that lies before it in the file. Errors: those
/// of GridSamples; cancelled().
Result<dicom::DecodedSlice> decodeGridSlice(const dicom::Series& series, const dicom::SliceRef& slice,
                                            const std::stop_token& stop);

}  // namespace pdr::app
