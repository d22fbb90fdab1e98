#include "app/cli/info_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/cli/series_report.h"
#include "dicom/import.h"

namespace pdr::app {

namespace {

using Json = nlohmann::ordered_json;

Json scanReport(const dicom::ScanResult& scan, const std::string& folder) {
    Json report = {{"folder", folder}, {"filesSeen", scan.filesSeen}, {"notDicom", scan.notDicom}};
    report["series"] = Json::array();
    for (const dicom::Series& series : scan.series)
        report["series"].push_back(reportOf(series));
    report["problems"] = Json::array();
    for (const dicom::Problem& problem : scan.problems)
        report["problems"].push_back({{"file", problem.file.string()}, {"reason", problem.reason}});
    return report;
}

void printText(const Json& report) {
    std::printf("%s: %d files, %d of them no DICOM\n", report["folder"].get<std::string>().c_str(),
                report["filesSeen"].get<int>(), report["notDicom"].get<int>());
    for (const Json& series : report["series"])
        std::printf("\n%s", textOf(series).c_str());
    for (const Json& problem : report["problems"])
        std::printf("\nproblem: %s: %s\n", problem["file"].get<std::string>().c_str(),
                    problem["reason"].get<std::string>().c_str());
}

}  // namespace

int runInfo(const QStringList& arguments) {
    QStringList folders = arguments;
    const bool asJson = folders.removeAll(QStringLiteral("--json")) > 0;
    if (folders.size() != 1 || folders.front().startsWith('-')) {
        std::fprintf(stderr, "usage: pdrender-cli info FOLDER [--json]\n");
        return 2;
    }
    const std::string folder = folders.front().toStdString();
    const Result<dicom::ScanResult> scan = dicom::scanFolder(folder, noProgress);
    if (!scan) {
        std::fprintf(stderr, "%s\n", scan.error().text().c_str());
        return 1;
    }
    const Json report = scanReport(*scan, folder);
    if (asJson)
        std::printf("%s\n", report.dump(2, ' ', false, Json::error_handler_t::replace).c_str());
    else
        printText(report);
    return 0;
}

}  // namespace pdr::app
