#include "app/jobs/parts_job.h"

#include <map>
#include <utility>
#include <vector>

#include "app/scan/scan_labels.h"
#include "render/segment/part_rules.h"
#include "render/volume/joined_labels.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

using SharedMap = std::shared_ptr<const LabelMap>;

/// The parts of a scan, each source by itself.
struct PartsJob::Maps {
    SharedMap labels;
    std::map<PartRule, SharedMap> found;
    std::string hash;  ///< labelsHash() of `labels`
};

namespace {

/// Finds what a rule finds, unless `found` holds it.
Result<void> find(SharedMap& found, PartRule rule, const Volume& volume, const Progress& progress) {
    if (found)
        return {};
    Result<LabelMap> map = segment::findParts(rule, volume, progress);
    if (!map)
        return map.error();
    found = std::make_shared<const LabelMap>(*std::move(map));
    return {};
}

/// A map, and whether a rule has found its parts.
struct Layer {
    SharedMap map;
    bool byRule = false;
};

/// Returns the maps of all sources: what others have marked first.
template <class Maps>
Result<std::vector<Layer>> layersOf(Maps& maps, const PartSources& sources, const Volume& volume,
                                    const Progress& progress) {
    std::vector<Layer> layers;
    if (!sources.labels.empty())
        layers.push_back({maps.labels, false});
    for (const PartRule rule : rulesOf(sources)) {
        SharedMap& map = maps.found[rule];
        if (auto ok = find(map, rule, volume, progress); !ok)
            return ok.error();
        layers.push_back({map, true});
    }
    return layers;
}

/// Returns one map of all layers.
Result<SharedMap> joined(const std::vector<Layer>& layers) {
    if (layers.size() == 1)
        return layers.front().map;
    JoinedLabels all;
    for (const Layer& layer : layers)
        if (auto ok = all.add(*layer.map); !ok)
            return ok.error();
    return std::make_shared<const LabelMap>(all.take());
}

using MadeParts = Result<std::shared_ptr<const ScanParts>>;

/// Returns the parts of all sources.
template <class Maps>
MadeParts partsOf(Maps& maps, const PartSources& sources, const Volume& volume, const Progress& progress) {
    const Result<std::vector<Layer>> layers = layersOf(maps, sources, volume, progress);
    if (!layers)
        return layers.error();
    Result<SharedMap> map = joined(*layers);
    if (!map)
        return map.error();
    ScanParts parts{*std::move(map), {}};
    for (const Layer& layer : *layers)
        parts.facts.insert(parts.facts.end(), layer.map->parts.size(), {layer.map->source, layer.byRule});
    const std::vector<double> ml = partsMl(*parts.map);
    for (std::size_t i = 0; i < ml.size(); ++i)
        parts.facts[i].ml = ml[i];
    return std::make_shared<const ScanParts>(std::move(parts));
}

}  // namespace

PartsJob::PartsJob() : maps_(std::make_shared<Maps>()) {}

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
        Maps known = *maps;
        known.labels = std::make_shared<const LabelMap>(*std::move(placed));
        known.hash = labelsHash(*known.labels);
        PartSources all = sources;
        all.labels = known.hash;
        const MadeParts parts = partsOf(known, all, *scan.volume, progress);
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
        const MadeParts parts = partsOf(*maps, all, *scan.volume, progress);
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
            if (!sources.labels.empty() && sources.labels != maps->hash)
                return [this, sources] { emit labelsMissing(sources); };
            const MadeParts parts = partsOf(*maps, sources, *scan.volume, progress);
            if (!parts)
                return failure(parts.error());
            return [this, sources, parts = *parts] { emit made(sources, parts); };
        });
}

void PartsJob::forget() {
    cancel();
    maps_ = std::make_shared<Maps>();
}

}  // namespace pdr::app
