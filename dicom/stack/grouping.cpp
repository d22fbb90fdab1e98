#include "dicom/stack/grouping.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "dicom/read/codecs.h"
#include "dicom/read/refusal.h"
#include "dicom/stack/concatenation.h"
#include "dicom/stack/copies.h"
#include "dicom/stack/damaged_files.h"
#include "dicom/stack/phases.h"
#include "dicom/stack/series_unit.h"
#include "dicom/stack/stack_geometry.h"
#include "dicom/stack/stack_notes.h"
#include "dicom/stack/value_range.h"

namespace pdr::dicom {

namespace {

using Headers = std::vector<const SliceHeader*>;

/// Returns the window of the middle slice. Where that has none, the first slice with one is asked, then the first that
/// says why it has none.
StatedWindow windowOf(const Headers& sorted) {
    const StatedWindow& middle = sorted[sorted.size() / 2]->window;
    if (middle.window)
        return middle;
    for (const SliceHeader* slice : sorted)
        if (slice->window.window)
            return slice->window;
    const auto ignored = std::ranges::find_if(sorted, [](const auto* slice) { return !slice->window.ignored.empty(); });
    return ignored == sorted.end() ? StatedWindow() : (*ignored)->window;
}

/// Returns the name of the slices' coding, if they have one in common.
Text codingOf(const Headers& headers) {
    const std::string& first = headers.front()->transferSyntaxUid;
    const bool isCommon =
        std::ranges::all_of(headers, [&](const auto* each) { return each->transferSyntaxUid == first; });
    return isCommon ? codingName(first) : phrase("several codings");
}

/// Returns headers in the order of their stack.
Headers sortedBy(const StackAnalysis& analysis, const Headers& headers) {
    Headers sorted;
    for (const int index : analysis.order)
        sorted.push_back(headers[index]);
    return sorted;
}

Series seriesOf(const Headers& sorted, const StackAnalysis& analysis, const ValueUnit& unit) {
    const SliceHeader& first = *sorted.front();
    Series series{first.patient, first.study, first.series, analysis.verdict, {}, analysis.geometry};
    for (const SliceHeader* slice : sorted)
        series.slices.push_back({slice->file, slice->frame, identityOf(*slice)});
    series.window = windowOf(sorted);
    series.unit = unit;
    series.series.coding = codingOf(sorted);
    return series;
}

/// Makes an entry of the even slices between those of `uneven`.
Series resampledSeries(const Series& uneven, const ResampledStack& stack) {
    Series series = uneven;
    series.series.resampled = true;
    series.verdict = {Stack::even, {}, uneven.verdict.notes};
    series.verdict.notes.insert(series.verdict.notes.begin(), stack.notes.begin(), stack.notes.end());
    series.blends = stack.blends;
    series.geometry = stack.geometry;
    return series;
}

/// Makes one entry for images that share one reason to be refused. They are still sorted if they have a position.
Series refusedSeries(const Headers& headers, const Refusal& refusal, const std::filesystem::path& root) {
    StackAnalysis analysis = analyseStack(planesOf(headers, root));
    analysis.geometry = {analysis.geometry.size, dmat4(1.0)};
    const std::string first = shortName(headers.front()->file, root);
    std::set<std::filesystem::path> files;
    for (const SliceHeader* header : headers)
        files.insert(header->file);
    const Text subject = files.size() == 1 ? Text(first) : phrase("%1 files (%2 ...)", files.size(), first);
    analysis.verdict = {refusal.stack, phrase("%1: %2", subject, refusal.reason), {}};
    const Headers sorted = sortedBy(analysis, headers);
    return seriesOf(sorted, analysis, seriesUnit(sorted, possibleValues(sorted)).unit);
}

/// Slices of one series that share a grid.
struct Part {
    Headers slices;
    Text phase;                 ///< empty: it is the only one
    std::size_t elsewhere = 0;  ///< number of slices of the series on other grids
    StackAnalysis analysis;
};

Text pieceReason(const SlicePlane& here, const SlicePlane& there) {
    const Text how = here.size == there.size ? phrase("%1 mm apart at a corner", inMm(gridDeviationMm(here, there)))
                                             : phrase("%1 here, %2 there", sizeText(here), sizeText(there));
    return phrase(
        "this is one piece of a stack whose other piece lies on another grid (%1): %2 and so on here, %3 and so on "
        "there",
        how, here.name, there.name);
}

/// Refuses the pieces of one stack: half a patient must not pass for a whole one.
void refusePieces(std::vector<Part>& parts, const std::filesystem::path& root) {
    const std::vector<Part> before = parts;
    for (Part& part : parts) {
        const auto self = std::size_t(&part - parts.data());
        for (std::size_t other = 0; other < parts.size(); ++other) {
            if (other == self || !part.analysis.verdict.loadable() || !before[other].analysis.verdict.loadable() ||
                !continues(part.analysis.geometry, before[other].analysis.geometry))
                continue;
            const auto planes = planesOf({part.slices.front(), before[other].slices.front()}, root);
            part.analysis.verdict.stack =
                planes[0].size == planes[1].size && *planes[0].spacingMm == *planes[1].spacingMm
                    ? Stack::mixedOrientation
                    : Stack::mixedSize;
            part.analysis.verdict.reason = pieceReason(planes[0], planes[1]);
            part.analysis.geometry = {part.analysis.geometry.size, dmat4(1.0)};
        }
    }
}

/// Adds the entries of CT slices that share a series.
void addStacks(const Headers& headers, const SeriesSource& source, const std::set<int>& numbers,
               const Progress& progress, std::vector<Series>& out) {
    const std::filesystem::path root = source.root();
    // Judge each part that shares a grid
    std::vector<Part> parts;
    const std::vector<std::vector<int>> grids = splitByGrid(planesOf(headers, root));
    for (const std::vector<int>& indices : grids) {
        Headers slices;
        for (const int index : indices)
            slices.push_back(headers[index]);
        const StackAnalysis together = analyseWithoutCopies(slices, source, progress);
        const std::vector<Phase> phases = phasesOf(slices);
        for (const Phase& phase : phases) {
            Part part{phase.slices, phase.name, headers.size() - indices.size(), together};
            if (phases.size() > 1)
                part.analysis = analyseStack(planesOf(part.slices, root));
            parts.push_back(std::move(part));
        }
    }
    if (grids.size() > 1)
        refusePieces(parts, root);
    // Add the notes, and make an entry of each part
    for (Part& part : parts) {
        GeometryVerdict& verdict = part.analysis.verdict;
        const Headers sorted = sortedBy(part.analysis, part.slices);
        const FittedUnit fitted = seriesUnit(sorted, valueRange(sorted, source, progress));
        if (verdict.loadable() || part.analysis.resampled) {
            const std::vector<Note> notes = notesOn(sorted, fitted, numbers);
            verdict.notes.insert(verdict.notes.end(), notes.begin(), notes.end());
        }
        if (grids.size() > 1)
            verdict.notes.push_back(
                {"parts", phrase(part.elsewhere == 1 ? "1 slice of this series on another grid listed apart"
                                                     : "%1 slices of this series on another grid listed apart",
                                 part.elsewhere)});
        out.push_back(seriesOf(sorted, part.analysis, fitted.unit));
        out.back().series.phase = part.phase;
        if (part.analysis.resampled)
            out.push_back(resampledSeries(out.back(), *part.analysis.resampled));
    }
}

/// Numbers the entries of each series, to tell them apart. A resampled one has the number of the one that it is made
/// of.
void numberParts(std::vector<Series>& all) {
    std::map<std::string, int> seen;
    for (Series& series : all)
        if (!series.series.resampled)
            series.series.part = ++seen[series.series.uid];
    for (Series& series : all)
        if (series.series.resampled) {
            const auto uneven = std::ranges::find_if(all, [&](const Series& other) {
                return !other.series.resampled && other.slices.front().file == series.slices.front().file &&
                       other.slices.front().frame == series.slices.front().frame;
            });
            series.series.part = uneven->series.part;
        }
}

std::string seriesKey(const SliceHeader& header) {
    return header.series.uid + '\n' + header.series.modality + '\n' + header.patient.id + '\n' +
           header.patient.birthDate;
}

/// Returns the slices of one series by their studies. Some de-identifiers give every file a study of its own: if each
/// slice has one, and all together are an even stack, they are one.
std::vector<Headers> byStudy(const Headers& headers, const std::filesystem::path& root) {
    std::map<std::string, Headers> studies;
    for (const SliceHeader* header : headers)
        studies[header->study.uid].push_back(header);
    const bool eachHasOne = studies.size() == headers.size() && studies.size() > 1;
    if (eachHasOne && analyseStack(planesOf(headers, root)).verdict.loadable())
        return {headers};
    std::vector<Headers> apart;
    apart.reserve(studies.size());
    for (auto& [uid, study] : studies)
        apart.push_back(std::move(study));
    return apart;
}

}  // namespace

std::vector<Series> groupIntoSeries(const std::vector<SliceHeader>& headers, const std::vector<SliceHeader>& damaged,
                                    const std::shared_ptr<const SeriesSource>& source, const Progress& progress) {
    const std::filesystem::path root = source->root();
    struct Kind {
        Headers headers;
        std::optional<Refusal> refusal;
    };
    // Sort the images by series and reason of refusal
    std::map<std::pair<std::string, std::string>, Kind> kinds;
    for (const SliceHeader& header : headers) {
        std::optional<Refusal> refusal = refuseSlice(header);
        Kind& kind = kinds[{seriesKey(header), refusal ? refusal->reason : Text()}];
        kind.headers.push_back(&header);
        kind.refusal = std::move(refusal);
    }
    // Collect the instance numbers of each series
    std::map<std::string, std::set<int>> numbersOf;
    for (const std::vector<SliceHeader>* some : {&headers, &damaged}) {
        for (const SliceHeader& header : *some) {
            if (header.instanceNumber)
                numbersOf[header.series.uid].insert(*header.instanceNumber);
        }
    }
    // Make the entries, loadable and larger ones first
    std::vector<Series> all;
    for (auto& [key, kind] : kinds) {
        for (const Headers& study : byStudy(kind.headers, root))
            if (kind.refusal)
                all.push_back(refusedSeries(study, *kind.refusal, root));
            else if (const Text missing = missingPart(study); !missing.empty())
                all.push_back(refusedSeries(study, {Stack::gap, missing}, root));
            else
                addStacks(study, *source, numbersOf[study.front()->series.uid], progress, all);
    }
    noteDamaged(damaged, root, all);
    const auto rank = [](const Series& series) {
        const auto slices = std::ptrdiff_t(series.slices.size());
        return std::tuple(!series.verdict.loadable(), series.series.resampled, !series.unit.isHu,
                          series.verdict.stack == Stack::notCt, -slices, series.series.number);
    };
    std::stable_sort(all.begin(), all.end(), [&](const Series& a, const Series& b) { return rank(a) < rank(b); });
    numberParts(all);
    for (Series& series : all)
        series.source = source;
    return all;
}

}  // namespace pdr::dicom
