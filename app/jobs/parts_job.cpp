#include "app/jobs/parts_job.h"

#include <utility>

#include "app/scan/scan_labels.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

PartsJob::PartsJob() : maps_(std::make_shared<PartMaps>()) {}

void PartsJob::open(const Scan& scan, const QString& file, Resampling resampling, const PartSources& sources) {
    making_.reset();
    start([this, scan, file, resampling, sources, maps = maps_](const Progress& progress,
                                                                const std::stop_token&) -> std::function<void()> {
        const std::filesystem::path path = ui::fromQt(file);
        const VolumeGeometry& grid = scan.volume->geometry();
        const dicom::Series* series = scan.series ? &*scan.series : nullptr;
        Result<LabelMap> read = readLabels(path, grid, series, progress);
        if (!read)
            return failure(read.error());
        Result<LabelMap> placed = labelsOn(grid, *read, resampling);
        if (!placed && labelsOn(grid, *std::move(read), Resampling::nearest))
            return [this, file, error = placed.error()] { emit resamplingWanted(file, error); };
        if (!placed)
            return failure(placed.error().in(path.string()));
        PartMaps known = *maps;
        known.setLabels(*std::move(placed));
        PartSources all = sources;
        all.labels = known.hash();
        const auto parts = known.make(all, *scan.volume, progress);
        if (!parts)
            return failure(parts.error());
        *maps = std::move(known);
        return [this, all, parts = *parts] { emit added(all, parts); };
    });
}

void PartsJob::find(const Scan& scan, PartRule rule, const PartSources& sources) {
    making_.reset();
    start([this, scan, all = withRule(sources, rule), maps = maps_](const Progress& progress,
                                                                    const std::stop_token&) -> std::function<void()> {
        const auto parts = maps->make(all, *scan.volume, progress);
        if (!parts)
            return failure(parts.error());
        return [this, all, parts = *parts] { emit added(all, parts); };
    });
}

void PartsJob::make(const Scan& scan, const PartSources& sources) {
    if (isRunning() && making_ == sources)
        return;
    making_ = sources;
    start(
        [this, scan, sources, maps = maps_](const Progress& progress, const std::stop_token&) -> std::function<void()> {
            if (!sources.labels.empty() && sources.labels != maps->hash())
                return [this, sources] { emit labelsMissing(sources); };
            const auto parts = maps->make(sources, *scan.volume, progress);
            if (!parts)
                return failure(parts.error());
            return [this, sources, parts = *parts] { emit made(sources, parts); };
        });
}

void PartsJob::forget() {
    cancel();
    maps_ = std::make_shared<PartMaps>();
}

}  // namespace pdr::app
