#include "dicom/grouping.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <tuple>

#include "dicom/pixels.h"
#include "dicom/refusal.h"
#include "dicom/stack_geometry.h"

namespace pdr::dicom {

namespace {

using Headers = std::vector<const SliceHeader*>;

std::string shortName(const SliceHeader& header, const std::filesystem::path& root) {
    return header.file.lexically_relative(root).string();
}

/// "1 slice", "3 slices"
std::string counted(std::size_t count, const char* one, const char* many) {
    return std::to_string(count) + ' ' + (count == 1 ? one : many);
}

std::vector<SlicePlane> planesOf(const Headers& headers, const std::filesystem::path& root) {
    std::vector<SlicePlane> planes;
    for (const SliceHeader* header : headers)
        planes.push_back({shortName(*header, root),
                          {header->columns, header->rows},
                          header->position,
                          header->rowDirection,
                          header->columnDirection,
                          header->spacingMm});
    return planes;
}

bool sameBytes(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code failure;
    if (std::filesystem::file_size(a, failure) != std::filesystem::file_size(b, failure) || failure)
        return false;
    std::ifstream left(a, std::ios::binary), right(b, std::ios::binary);
    std::vector<char> leftPart(1 << 16), rightPart(1 << 16);
    while (left && right) {
        left.read(leftPart.data(), std::streamsize(leftPart.size()));
        right.read(rightPart.data(), std::streamsize(rightPart.size()));
        if (left.gcount() != right.gcount() ||
            !std::equal(leftPart.begin(), leftPart.begin() + left.gcount(), rightPart.begin()))
            return false;
    }
    return left.eof() && right.eof();
}

bool samePicture(const SliceHeader& a, const SliceHeader& b) {
    if (sameBytes(a.file, b.file))
        return true;
    const auto left = decodeSlice({a.file, 0}, Padding::keep), right = decodeSlice({b.file, 0}, Padding::keep);
    return left && right && left->hu == right->hu;
}

/// The first three names, and a sign that there are more.
std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 3); ++i) {
        if (i > 0)
            list += ", ";
        list += names[i];
    }
    return names.size() > 3 ? list + " ..." : list;
}

/// The slices that repeat another one; empty as soon as there is one conflict (or the user has lost patience).
std::set<int> copiesAmong(const Headers& headers, const StackAnalysis& analysis, const Progress& progress) {
    std::set<int> copies;
    for (const auto& [first, other] : analysis.samePlace) {
        const double done = double(copies.size()) / double(analysis.samePlace.size());
        if (!progress(done, "comparing slices at the same place") || !samePicture(*headers[first], *headers[other]))
            return {};
        copies.insert(other);
    }
    return copies;
}

/// Judges the stack; copies of slices are taken out of `headers` first, and noted.
StackAnalysis analyseWithoutCopies(Headers& headers, const std::filesystem::path& root, const Progress& progress) {
    StackAnalysis analysis = analyseStack(planesOf(headers, root));
    const std::set<int> copies = copiesAmong(headers, analysis, progress);
    if (copies.empty())
        return analysis;
    std::vector<std::string> names;
    Headers kept;
    for (int i = 0; i < int(headers.size()); ++i) {
        if (copies.contains(i))
            names.push_back(shortName(*headers[i], root));
        else
            kept.push_back(headers[i]);
    }
    headers = kept;
    analysis = analyseStack(planesOf(headers, root));
    analysis.verdict.notes.push_back(counted(copies.size(), "copy of a slice", "copies of slices") + " left out (" +
                                     listed(names) + ")");
    return analysis;
}

/// What a user should know about slices that load all the same.
void addNotes(GeometryVerdict& verdict, const Headers& headers) {
    if (!verdict.loadable())
        return;
    std::size_t withoutRescale = 0;
    std::set<std::string> frames, units;
    for (const SliceHeader* header : headers) {
        withoutRescale += !header->meaning.slope || !header->meaning.intercept;
        frames.insert(header->frameOfReferenceUid);
        units.insert(header->meaning.unit);
    }
    if (withoutRescale > 0)
        verdict.notes.push_back(counted(withoutRescale, "slice states", "slices state") +
                                " no rescale; stored values are taken as HU");
    for (const std::string& unit : units) {
        if (!unit.empty() && unit != "HU")
            verdict.notes.push_back("the files say that their values are in \"" + unit + "\"; they are taken as HU");
    }
    // Some de-identifiers give every file a frame of its own; a true second frame would show as a broken stack.
    if (frames.size() > 1)
        verdict.notes.push_back("the files name " + std::to_string(frames.size()) +
                                " frames of reference; their positions are taken as one");
}

Series seriesOf(const Headers& headers, const StackAnalysis& analysis) {
    const SliceHeader& first = *headers.front();
    Series series{first.patient, first.study, first.series, analysis.verdict, {}, analysis.geometry};
    for (const int index : analysis.order)
        series.slices.push_back({headers[index]->file, 0});
    return series;
}

/// One entry for images that all share one reason to be refused. They are still sorted where they have a place.
Series refusedSeries(const Headers& headers, const Refusal& refusal, const std::filesystem::path& root) {
    StackAnalysis analysis = analyseStack(planesOf(headers, root));
    analysis.geometry = {analysis.geometry.size, dmat4(1.0)};
    const std::string subject =
        headers.size() == 1 ? shortName(*headers.front(), root)
                            : std::to_string(headers.size()) + " files (" + shortName(*headers.front(), root) + " ...)";
    analysis.verdict = {refusal.stack, subject + ": " + refusal.reason, {}};
    return seriesOf(headers, analysis);
}

/// The entries of CT slices that share a series.
void addStacks(const Headers& headers, const std::filesystem::path& root, const Progress& progress,
               std::vector<Series>& out) {
    const std::vector<std::vector<int>> parts = splitByGrid(planesOf(headers, root));
    for (const std::vector<int>& part : parts) {
        Headers slices;
        for (const int index : part)
            slices.push_back(headers[index]);
        StackAnalysis analysis = analyseWithoutCopies(slices, root, progress);
        addNotes(analysis.verdict, slices);
        if (parts.size() > 1)
            analysis.verdict.notes.push_back(counted(headers.size() - part.size(), "slice", "slices") +
                                             " of this series on another grid listed apart");
        out.push_back(seriesOf(slices, analysis));
    }
}

std::string seriesKey(const SliceHeader& header) {
    return header.study.uid + '\n' + header.series.uid + '\n' + header.series.modality;
}

void noteDamaged(const std::vector<SliceHeader>& damaged, const std::filesystem::path& root, std::vector<Series>& all) {
    std::map<std::string, std::vector<std::string>> namesOf;
    for (const SliceHeader& header : damaged) {
        if (!header.series.uid.empty())
            namesOf[header.series.uid].push_back(shortName(header, root));
    }
    for (Series& series : all) {
        const auto found = namesOf.find(series.series.uid);
        if (found == namesOf.end() || series.verdict.stack == Stack::notCt)
            continue;
        series.verdict.notes.push_back(counted(found->second.size(), "damaged file", "damaged files") +
                                       " of this series left out (" + listed(found->second) + ")");
    }
}

}  // namespace

std::vector<Series> groupIntoSeries(const std::vector<SliceHeader>& headers, const std::vector<SliceHeader>& damaged,
                                    const std::filesystem::path& root, const Progress& progress) {
    struct Kind {
        Headers headers;
        std::optional<Refusal> refusal;
    };
    std::map<std::pair<std::string, std::string>, Kind> kinds;
    for (const SliceHeader& header : headers) {
        std::optional<Refusal> refusal = refuseSlice(header);
        Kind& kind = kinds[{seriesKey(header), refusal ? refusal->reason : ""}];
        kind.headers.push_back(&header);
        kind.refusal = std::move(refusal);
    }
    std::vector<Series> all;
    for (auto& [key, kind] : kinds) {
        if (kind.refusal)
            all.push_back(refusedSeries(kind.headers, *kind.refusal, root));
        else
            addStacks(kind.headers, root, progress, all);
    }
    noteDamaged(damaged, root, all);
    const auto rank = [](const Series& series) {
        const auto slices = std::ptrdiff_t(series.slices.size());
        return std::tuple(!series.verdict.loadable(), series.verdict.stack == Stack::notCt, -slices,
                          series.series.number);
    };
    std::stable_sort(all.begin(), all.end(), [&](const Series& a, const Series& b) { return rank(a) < rank(b); });
    return all;
}

}  // namespace pdr::dicom
