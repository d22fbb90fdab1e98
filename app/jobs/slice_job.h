#pragma once
/// Computes the slices of one view in the background. Requests that come while one is computed are dropped but for the
/// newest, so that a view that is scrolled through always shows what it can.

#include <QImage>
#include <memory>
#include <optional>

#include "app/jobs/background_job.h"
#include "app/jobs/slice_tint.h"
#include "app/scan/sliced_scan.h"
#include "render/slice/grey_window.h"
#include "render/slice/slice_plane.h"

namespace pdr::app {

class SliceJob : public BackgroundJob {
    Q_OBJECT

  public:
    /// What to compute: the slice of `scan` on `plane`, seen through `window`, with parts in colours.
    struct Request {
        SlicedScan scan;
        SlicePlane plane;
        GreyWindow window;
        bool coarse = false;  ///< at half the resolution, for a quarter of the work
        SliceTint tint = {};
        bool operator==(const Request&) const = default;
    };

    SliceJob();
    /// Computes the slice, after the one in progress; ends with made() unless a newer request comes before it begins.
    /// A request that equals the newest one, or asks for a coarse slice where that asks for the same in full, does
    /// nothing.
    void make(Request request);
    /// Returns the pixels of a slice of a complete volume, computed on the calling thread.
    static QImage madeNow(const Request& request);
    /// Drops all requests and releases their volumes, once the work in progress has ended.
    void drop();

  signals:
    /// `grey`: the pixels of `plane`, row by row from the top; a coarse one holds those of halved(plane). What has not
    /// arrived is hatched.
    void made(const QImage& grey, const pdr::SlicePlane& plane, const pdr::GreyWindow& window);

  private:
    bool isAnswered(const Request& request) const;
    void begin(Request request);

    std::optional<Request> newest_;  ///< none before the first, and after one that failed
    bool waits_ = false;             ///< the newest request waits for the one in progress
    /// The HU of the slice before, for the next one; used on the job's thread alone.
    std::shared_ptr<std::vector<float>> memory_ = std::make_shared<std::vector<float>>();
};

}  // namespace pdr::app
