#include "app/cli/scan/info_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/failed.h"
#include "app/cli/progress_line.h"
#include "app/cli/scan/series_report.h"
#include "app/cli/step_clock.h"
#include "app/scan/scan_place.h"

namespace pdr::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kHelp =
    "pdrender-cli info FOLDER [--json] [--descriptions] [--times]\n"
    "\n"
    "Lists every series below FOLDER, which may also be a ZIP archive or a volume file (NIfTI, NRRD, MetaImage): its\n"
    "grid in the patient, its HU with and without padding, or its values and their unit where they are none, a\n"
    "checksum (SHA-256 of the voxels as int16, x fastest,\n"
    "before padding is masked), whether it can be loaded and if not, why. Never a name.\n"
    "  --json           the same for other programs\n"
    "  --descriptions   also what was written about each series; people write names there\n"
    "  --times          also the seconds of each step: listing the folder; from files to voxels; what follows\n";

Json scanReport(const dicom::ScanResult& scan, const std::string& folder, const WantedFacts& wanted,
                const Progress& progress) {
    Json report = {{"folder", folder}, {"filesSeen", scan.filesSeen}, {"notDicom", scan.notDicom}};
    report["series"] = Json::array();
    for (const dicom::Series& series : scan.series)
        report["series"].push_back(reportOf(series, wanted, progress));
    report["problems"] = Json::array();
    for (const dicom::Problem& problem : scan.problems)
        report["problems"].push_back({{"file", problem.file.string()}, {"reason", problem.reason}});
    return report;
}

void printText(const Json& report) {
    const int files = report["filesSeen"].get<int>();
    std::printf("%s: %d %s, %d of them no scan\n", report["folder"].get<std::string>().c_str(), files,
                files == 1 ? "file" : "files", report["notDicom"].get<int>());
    for (const Json& series : report["series"])
        std::printf("\n%s", textOf(series).c_str());
    if (report.contains("scanSeconds"))
        std::printf("\nlisted in %.3f s\n", report["scanSeconds"].get<double>());
    for (const Json& problem : report["problems"])
        std::printf("\nproblem: %s: %s\n", problem["file"].get<std::string>().c_str(),
                    problem["reason"].get<std::string>().c_str());
}

}  // namespace

int runInfo(const QStringList& arguments) {
    QStringList folders = arguments;
    const bool asJson = folders.removeAll(QStringLiteral("--json")) > 0;
    const WantedFacts wanted{.description = folders.removeAll(QStringLiteral("--descriptions")) > 0,
                             .times = folders.removeAll(QStringLiteral("--times")) > 0};
    if (folders.contains("--help") || folders.contains("-h")) {
        std::fputs(kHelp, stdout);
        return 0;
    }
    if (folders.size() != 1 || folders.front().startsWith('-')) {
        std::fprintf(stderr, "usage: %s", kHelp);
        return 2;
    }
    ProgressLine line;
    const Progress progress = line.until();
    const std::string folder = folders.front().toStdString();
    StepClock clock;
    const Result<dicom::ScanResult> scan = scanPlace(folder, progress);
    if (!scan) {
        line.finish();
        return failed(scan.error());
    }
    const StepTime scanned = clock.lap();
    Json report = scanReport(*scan, folder, wanted, progress);
    if (wanted.times)
        addTime(report, "scan", scanned);
    line.finish();
    if (asJson)
        std::printf("%s\n", report.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    else
        printText(report);
    return 0;
}

}  // namespace pdr::app
