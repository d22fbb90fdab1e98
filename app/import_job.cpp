#include "app/import_job.h"

#include <QThread>
#include <utility>

#include "dicom/import.h"
#include "render/base/errors.h"
#include "ui/to_qt.h"

namespace pdr::app {
namespace {

/// Returns false if it was cancelled.
bool waitUntilFreed(const std::weak_ptr<const Volume>& volume, const Progress& progress) {
    while (!volume.expired()) {
        if (!progress(0, "closing the series before"))
            return false;
        QThread::msleep(5);
    }
    return true;
}

}  // namespace

void ImportJob::scanFolder(const QString& folder) {
    start([this, folder](const Progress& progress, const std::stop_token&) -> std::function<void()> {
        auto result = dicom::scanFolder(ui::fromQt(folder), progress);
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
    start([this, index, series = scan_.series[std::size_t(index)], before = lastLoaded_](
              const Progress& progress, const std::stop_token&) -> std::function<void()> {
        for (const auto& volume : before)
            if (!waitUntilFreed(volume, progress))
                return failure(pdr::cancelled());
        std::vector<dicom::Note> notes;
        auto result = dicom::loadSeries(series, dicom::Padding::maskAsAir, partOf(progress, 0, 0.9), &notes);
        if (!result)
            return failure(result.error());
        auto volume = std::make_shared<const Volume>(std::move(*result));
        auto table = segment::hideTable(*volume, partOf(progress, 0.9, 1));
        if (!table)
            return failure(table.error());
        const segment::Findings findings = segment::findingsOn(table->body ? *table->body : *volume, table->bodyBox);
        return [this, index, volume, notes, table = *std::move(table), findings] {
            loadNotes_ = notes;
            lastLoaded_ = {volume, table.body};
            emit loaded(volume, index, table, findings);
        };
    });
}

}  // namespace pdr::app
