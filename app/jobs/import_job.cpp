#include "app/jobs/import_job.h"

#include <QDeadlineTimer>
#include <QThread>
#include <utility>

#include "app/scan/scan_place.h"
#include "app/scan/seen_series.h"
#include "render/base/errors.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

/// Waits until all holders have released `volume`. Those that receive Document::closing() release it soon, the renderer
/// after the launch in progress. The wait is limited all the same: a holder that does not release it is a fault, which
/// must be reported rather than keep a surgeon from a scan.
Result<void> waitUntilFreed(const std::weak_ptr<const Volume>& volume, std::chrono::milliseconds patience,
                            const Progress& progress) {
    const QDeadlineTimer end(patience);
    while (!volume.expired()) {
        if (!progress(0, "closing the previous series"))
            return cancelled();
        if (end.hasExpired())
            return Error{phrase("the previous series is still in memory"), "",
                         phrase("Open the series again, or restart the program.")};
        QThread::msleep(5);
    }
    return {};
}

}  // namespace

void ImportJob::scanFolder(const QString& folder) {
    start([this, folder](const Progress& progress, const std::stop_token&) -> std::function<void()> {
        auto result = scanPlace(ui::fromQt(folder), progress);
        if (!result)
            return failure(result.error());
        return [this, folder, scan = std::move(*result)] {
            scan_ = scan;
            emit scanned(scan_, folder);
        };
    });
}

void ImportJob::loadSeries(int index) {
    if (index < 0 || index >= int(scan_.series.size()))
        return;
    start([this, index, series = scan_.series[std::size_t(index)], before = lastLoaded_, patience = patience_](
              const Progress& progress, const std::stop_token& stop) -> std::function<void()> {
        // Wait for the memory of the previous volume
        if (auto freed = waitUntilFreed(before, patience, progress); !freed)
            return failure(freed.error());
        // Read the series, and hide its table
        const dicom::OnArrival onArrival = [this, index, &stop](std::shared_ptr<const ArrivingVolume> volume) {
            report(stop, [this, index, volume = std::move(volume)] { emit arriving(volume, index); });
        };
        auto seen = seenSeries(series, progress, onArrival);
        if (!seen)
            return failure(seen.error());
        const segment::Findings findings = segment::findingsOn(*seen->volume, seen->table.bodyBox);
        return [this, index, seen = *seen, findings] {
            loadNotes_ = seen.notes;
            lastLoaded_ = seen.volume;
            emit loaded(seen.volume, index, seen.table, findings, seen.hidden);
        };
    });
}

}  // namespace pdr::app
