#include "app/cli/plan/plan_command.h"

#include <cstdio>
#include <optional>
#include <utility>

#include "app/cli/failed.h"
#include "app/cli/plan/marks_report.h"
#include "app/cli/plan/plan_options.h"
#include "app/cli/plan/plan_scene.h"
#include "app/cli/render/image_run.h"
#include "app/cli/run_command.h"
#include "app/output/image_files.h"
#include "app/plan/marks_file.h"
#include "app/plan/scan_fit.h"

namespace pdr::app {
namespace {

/// A plan, and the scan on which it was made if that is at hand.
struct ReadPlan {
    SavedPlan saved;
    std::optional<ScannedVolume> scanned;
};

Paths outputsOf(const PlanOptions& options) {
    Paths all = options.tables;
    if (options.image)
        all.insert(all.end(), options.image->outputs.begin(), options.image->outputs.end());
    return all;
}

/// Reads the plan and its scan. Errors: those of both; the scan is another one.
Result<ReadPlan> readAll(const PlanOptions& options, const std::stop_token& stop) {
    auto saved = readPlan(options.file);
    if (!saved)
        return saved.error();
    if (options.scan.empty())
        return ReadPlan{*std::move(saved), {}};
    // A plan is marked with the scan as the window has it
    auto scanned = scannedVolume(options.scan, options.seriesUid, Table::hidden, stop);
    if (!scanned)
        return scanned.error();
    if (auto ok = checkIsScanOf(saved->scan, *scanned->seen); !ok)
        return Error{ok.error().what, options.scan.string(), "Name the series on which the plan was made.",
                     ok.error().kind};
    if (auto ok = checkPlaces(saved->plan, scanned->seen->geometry()); !ok)
        return Error{ok.error().what, options.file.string(), ok.error().hint, ok.error().kind};
    scanned->files.push_back(options.file);
    return ReadPlan{*std::move(saved), *std::move(scanned)};
}

void tell(const std::vector<MarkRow>& rows, const ScanMark& scan, bool onScan, bool json) {
    std::fputs((json ? jsonText(rows, scan, onScan) : plainText(rows)).c_str(), stdout);
    if (!onScan)
        std::fprintf(stderr,
                     "note: the scan was not read: whether the plan belongs to it, and values that depend on "
                     "voxels, are not known; --scan names it.\n");
}

/// Writes the tables. Returns whether all are in their place.
bool writeTables(const std::vector<MarkRow>& rows, const PlanOptions& options) {
    bool all = true;
    for (const auto& file : options.tables) {
        const auto written = writeMarks(rows, file);
        if (!written)
            failed(written.error());
        else if (!options.json)
            std::printf("%s\n", file.c_str());
        all = all && written;
    }
    return all;
}

int renderPlan(const Plan& plan, const ScannedVolume& scanned, const PlanOptions& options, const Interrupt& interrupt) {
    const auto load = [&](const Progress& progress) {
        return sceneOfPlan(plan, scanned, options.labels, *options.image->scene.size, progress);
    };
    // With --json the measurements alone are on standard output
    const auto say = [&](const RenderReport& report) {
        std::fputs(plainText(report).c_str(), options.json ? stderr : stdout);
    };
    return renderImages(*options.image, {load, say}, interrupt);
}

int listPlan(const PlanOptions& options, const Interrupt& interrupt) {
    if (auto ok = checkWritable(outputsOf(options)); !ok)
        return failed(ok.error());
    const auto read = readAll(options, interrupt.token());
    if (!read)
        return failed(read.error());
    const Paths inputs = read->scanned ? read->scanned->files : Paths{options.file};
    if (auto ok = checkSpared(inputs, outputsOf(options)); !ok)
        return failed(ok.error());
    const Plan& plan = read->saved.plan;
    const bool onScan = read->scanned.has_value();
    const std::vector<MarkRow> rows =
        onScan ? marksTable(plan, *volumeOf(plan, *read->scanned)) : marksTableWithoutScan(read->saved);
    tell(rows, read->saved.scan, onScan, options.json);
    const bool written = writeTables(rows, options);
    const int rendered = options.image ? renderPlan(plan, *read->scanned, options, interrupt) : 0;
    return written ? rendered : 1;
}

}  // namespace

int runPlan(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("plan", planOptions(arguments), planHelp,
                      [&](const PlanOptions& options) { return listPlan(options, interrupt); });
}

}  // namespace pdr::app
