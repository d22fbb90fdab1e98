#include "app/scan/series_choice.h"

#include <algorithm>
#include <set>

namespace pdr::app {

namespace {

/// Returns whether a series is one of those that are shown unasked. Those in HU come before all others.
auto preferredOf(const dicom::ScanResult& scan) {
    const auto isInHu = [](const dicom::Series& series) { return isShownUnasked(series) && series.unit.isHu; };
    return [anyInHu = std::ranges::any_of(scan.series, isInHu)](const dicom::Series& series) {
        return isShownUnasked(series) && (series.unit.isHu || !anyInHu);
    };
}

}  // namespace

bool isShownUnasked(const dicom::Series& series) {
    return series.verdict.loadable() && !series.series.resampled;
}

int firstLoadable(const dicom::ScanResult& scan) {
    const auto first = std::ranges::find_if(scan.series, preferredOf(scan));
    return first == scan.series.end() ? -1 : int(first - scan.series.begin());
}

int onlyLoadable(const dicom::ScanResult& scan) {
    const auto another = [&](const dicom::Series& series) {
        return !dicom::samePatient(series.patient, scan.series.front().patient);
    };
    if (std::ranges::count_if(scan.series, preferredOf(scan)) != 1 || std::ranges::any_of(scan.series, another))
        return -1;
    return firstLoadable(scan);
}

Error nothingLoadable(const dicom::ScanResult& scan) {
    std::set<std::string> told;
    Text reasons;
    for (const dicom::Series& series : scan.series)
        if (const Text& reason = series.verdict.reason; !reason.empty() && told.insert(reason).second)
            reasons = reasons.empty() ? reason : phrase("%1; %2", reasons, reason);
    if (reasons.empty() && !scan.problems.empty())
        reasons = scan.problems.front().reason;
    return {
        reasons.empty() ? phrase("no series here can be loaded") : phrase("no series here can be loaded: %1", reasons),
        "", "", ErrorKind::refused};
}

Result<dicom::Series> chosenSeries(const dicom::ScanResult& scan, const std::string& id) {
    if (!id.empty()) {
        const auto named = std::ranges::find_if(scan.series, [&](const auto& each) { return each.series.id() == id; });
        if (named != scan.series.end())
            return *named;
        return Error{phrase("there is no series %1 here", id), "",
                     phrase("\"pdrender-cli info FOLDER\" lists those that there are."), ErrorKind::refused};
    }
    if (const int first = firstLoadable(scan); first >= 0)
        return scan.series[std::size_t(first)];
    Error error = nothingLoadable(scan);
    const auto resampled = std::ranges::find_if(scan.series, [](const auto& each) { return each.series.resampled; });
    error.hint = resampled == scan.series.end()
                     ? phrase("\"pdrender-cli info FOLDER\" lists all of them.")
                     : phrase("\"--series %1\" interpolates even slices between those that were measured.",
                              resampled->series.id());
    return error;
}

}  // namespace pdr::app
