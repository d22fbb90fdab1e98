#include "app/cli/scan/series_report.h"

#include <QByteArray>
#include <QByteArrayView>
#include <QCryptographicHash>
#include <algorithm>
#include <cstdio>

#include "app/scan/scan_place.h"
#include "render/segment/hidden_table.h"
#include "render/volume/sheared.h"

namespace pdr::app {

namespace {

using Json = nlohmann::ordered_json;

/// A verdict as a name for other programs and as words for a person.
struct Verdict {
    dicom::Stack stack;
    const char *name, *words;
};

constexpr Verdict kVerdicts[] = {
    {dicom::Stack::even, "even", "can be loaded"},
    {dicom::Stack::singleSlice, "singleSlice", "a single slice, no volume"},
    {dicom::Stack::gap, "gap", "cannot be loaded, the slices are unevenly spaced"},
    {dicom::Stack::doubled, "doubled", "cannot be loaded, two slices lie at one place"},
    {dicom::Stack::tilted, "tilted", "cannot be loaded, the slices do not lie in a straight line"},
    {dicom::Stack::mixedOrientation, "mixedOrientation", "cannot be loaded, slices look in different directions"},
    {dicom::Stack::mixedSize, "mixedSize", "cannot be loaded, slices differ in size"},
    {dicom::Stack::noGeometry, "noGeometry", "cannot be loaded, the geometry is not stated"},
    {dicom::Stack::notCt, "notCt", "not a CT volume"},
    {dicom::Stack::unreadable, "unreadable", "cannot be read"},
};

const char* nameOf(dicom::Stack stack) {
    return std::ranges::find(kVerdicts, stack, &Verdict::stack)->name;
}

std::string wordsFor(const std::string& name) {
    return std::ranges::find_if(kVerdicts, [&](const Verdict& verdict) { return verdict.name == name; })->words;
}

Json vectorOf(const dvec3& v) {
    return {v.x, v.y, v.z};
}

void addGrid(Json& report, const VolumeGeometry& geometry) {
    const dvec3 spacing = statedSpacingMm(geometry);
    const dvec2 drift = sliceDrift(geometry).sidewaysMm;
    report["spacingMm"] = vectorOf(spacing);
    report["driftMm"] = {drift.x, drift.y};
    report["originMm"] = vectorOf(dvec3(geometry.patientFromIndex[3]));
    report["rowDirection"] = vectorOf(dvec3(geometry.patientFromIndex[0]) / spacing.x);
    report["columnDirection"] = vectorOf(dvec3(geometry.patientFromIndex[1]) / spacing.y);
}

/// Returns a number of voxels' unit, as it is shown: HU are whole.
Json valueOf(const ValueUnit& unit, int voxel) {
    return unit.isPlain() ? Json(voxel) : Json(unit.valueOf(voxel));
}

/// Returns the lowest, highest and mean value of the voxels for which counts(index) is true, in the volume's unit; null
/// if there are none.
template <class Counts>
Json statisticsOf(const Volume& volume, Counts counts) {
    std::int64_t sum = 0, count = 0;
    int lowest = INT16_MAX, highest = INT16_MIN;
    const auto voxels = volume.voxels();
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (!counts(i))
            continue;
        sum += voxels[i];
        ++count;
        lowest = std::min<int>(lowest, voxels[i]);
        highest = std::max<int>(highest, voxels[i]);
    }
    if (count == 0)
        return nullptr;
    const ValueUnit unit = unitOf(volume);
    return {{"voxels", count},
            {"lowest", valueOf(unit, lowest)},
            {"highest", valueOf(unit, highest)},
            {"mean", unit.valueOf(double(sum) / double(count))}};
}

std::string checksumOf(const Volume& volume) {
    const auto voxels = volume.voxels();
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArrayView(reinterpret_cast<const char*>(voxels.data()), qsizetype(voxels.size_bytes())));
    return hash.result().toHex().toStdString();
}

/// Adds what is known of the table.
void addTable(Json& report, const Volume& volume, const Progress& progress) {
    const auto table = segment::findTable(volume, progress);
    if (!table)
        return;
    report["table"] = {{"hiddenMl", table->hiddenMl}, {"touchedMl", table->cutMl},
                       {"bodyMl", table->bodyMl},     {"metalMl", table->metalMl},
                       {"parts", table->parts},       {"text", segment::tableText(*table)}};
}

void addPixels(Json& report, const dicom::Series& series, bool withTimes, const Progress& progress) {
    StepClock clock;
    const auto addSeconds = [&](const std::string& step) {
        if (const StepTime time = clock.lap(); withTimes)
            addTime(report, step, time);
    };
    std::vector<dicom::Note> notes;
    const Result<Volume> volume = loadVoxels(series, dicom::Padding::keep, progress, &notes);
    if (!volume) {
        if (series.verdict.loadable()) {
            report["loadable"] = false;
            report["error"] = volume.error().text();
        }
        return;
    }
    addSeconds("read");
    for (const dicom::Note& note : notes)
        report["notes"].push_back(note.text);
    const std::string values = series.unit.isHu ? "hu" : "values";
    report[values] = statisticsOf(*volume, [](std::size_t) { return true; });
    report[values + "WithoutPadding"] = statisticsOf(*volume, [&](std::size_t i) { return !volume->isPadding(i); });
    report["paddingVoxels"] = volume->paddingCount();
    addSeconds("statistics");
    report["sha256"] = checksumOf(*volume);
    addSeconds("checksum");
    if (!series.verdict.loadable())
        return;
    addTable(report, *volume, progress);
    addSeconds("table");
}

std::string joined(const Json& numbers, const char* separator) {
    std::string line;
    for (const Json& value : numbers) {
        char text[32];
        std::snprintf(text, sizeof text, "%.6g", value.get<double>());
        line += (line.empty() ? "" : separator) + std::string(text);
    }
    return line;
}

/// Returns "CT series 3", followed by the description if it was requested and there is one.
std::string headline(const Json& report) {
    const auto modality = report["modality"].get<std::string>();
    std::string line =
        (modality.empty() ? "modality unknown," : modality) + " series " + std::to_string(report["number"].get<int>());
    const std::string description = report.value("description", "");
    if (!description.empty())
        line += " \"" + description + "\"";
    const std::string phase = report.value("phase", "");
    return phase.empty() ? line : line + ", " + phase;
}

std::string statisticsLine(const char* label, const Json& statistics) {
    if (!statistics.is_object())
        return {};
    char line[128];
    std::snprintf(line, sizeof line, "  %-16s %.9g .. %.9g, mean %.9f\n", label, statistics["lowest"].get<double>(),
                  statistics["highest"].get<double>(), statistics["mean"].get<double>());
    return line;
}

/// Returns "no HU, Bq/ml, in steps of 0.25" for values that are no HU.
std::string unitLine(const Json& report) {
    const auto name = report["unit"].get<std::string>();
    std::string line = "no HU, " + (name.empty() ? "none stated" : name);
    if (const double step = report["valueStep"].get<double>(); step != 1)
        line += ", in steps of " + numberOf(step);
    return line;
}

std::string tableLine(const Json& table) {
    if (table["parts"] == 0)
        return "  table            " + table["text"].get<std::string>() + "\n";
    char line[160];
    std::snprintf(line, sizeof line, "  body             %.0f ml; outside %.0f ml, of which %.0f ml touched the skin\n",
                  table["bodyMl"].get<double>(), table["hiddenMl"].get<double>(), table["touchedMl"].get<double>());
    return line;
}

std::string secondsLine(const char* step, double seconds) {
    char line[64];
    std::snprintf(line, sizeof line, "  %-16s %.3f s\n", step, seconds);
    return line;
}

}  // namespace

void addTime(Json& report, const std::string& step, const StepTime& time) {
    report[step + "Seconds"] = time.passed;
    report[step + "ProcessorSeconds"] = time.processor;
}

Json reportOf(const dicom::Series& series, const WantedFacts& wanted, const Progress& progress) {
    Json report = {{"id", series.series.id()},
                   {"uid", series.series.uid},
                   {"modality", series.series.modality},
                   {"number", series.series.number},
                   {"date", series.series.date},
                   {"coding", std::string(series.series.coding)},
                   {"slices", series.slices.size()},
                   {"unit", series.unit.isHu ? Json("HU") : Json(series.unit.name)},
                   {"valueStep", series.unit.step},
                   {"valueZero", series.unit.zero},
                   {"verdict", nameOf(series.verdict.stack)},
                   {"loadable", series.verdict.loadable()},
                   {"resampled", series.series.resampled},
                   {"reason", series.verdict.reason},
                   {"notes", Json::array()}};
    for (const dicom::Note& note : series.verdict.notes)
        report["notes"].push_back(note.text);
    if (wanted.description)
        report["description"] = series.series.description;
    if (!series.series.phase.empty())
        report["phase"] = std::string(series.series.phase);
    const ivec3 size = series.geometry.size;
    if (size.x > 0)
        report["size"] = {size.x, size.y, size.z};
    if (series.verdict.loadable())
        addGrid(report, series.geometry);
    if (series.verdict.stack != dicom::Stack::unreadable)
        addPixels(report, series, wanted.times, progress);
    return report;
}

std::string textOf(const Json& report) {
    const int images = report["slices"].get<int>();
    std::string text = headline(report) + ", " + std::to_string(images) + (images == 1 ? " image: " : " images: ") +
                       (report.contains("error") ? "cannot be loaded, see the error"
                                                 : wordsFor(report["verdict"].get<std::string>())) +
                       (report["resampled"].get<bool>() ? ", resampled\n" : "\n");
    if (const auto reason = report["reason"].get<std::string>(); !reason.empty())
        text += "  reason           " + reason + "\n";
    for (const Json& note : report["notes"])
        text += "  note             " + note.get<std::string>() + "\n";
    if (report.contains("size"))
        text += "  size             " + joined(report["size"], " x ") + "\n";
    if (report.contains("values"))
        text += "  unit             " + unitLine(report) + "\n";
    if (const auto coding = report["coding"].get<std::string>(); !coding.empty())
        text += "  coding           " + coding + "\n";
    if (report.contains("spacingMm")) {
        text += "  spacing          " + joined(report["spacingMm"], " x ") + " mm\n";
        if (report["driftMm"] != Json{0.0, 0.0})
            text += "  drift            " + joined(report["driftMm"], ", ") + " mm a slice, along rows and columns\n";
        text += "  origin           " + joined(report["originMm"], ", ") + " mm\n";
        text += "  row direction    " + joined(report["rowDirection"], ", ") + "\n";
        text += "  column direction " + joined(report["columnDirection"], ", ") + "\n";
    }
    if (report.contains("sha256")) {
        const std::string values = report.contains("hu") ? "hu" : "values";
        text += statisticsLine(report.contains("hu") ? "HU" : "values", report[values]);
        text += statisticsLine("without padding", report[values + "WithoutPadding"]);
        text += "  padding          " + std::to_string(report["paddingVoxels"].get<std::int64_t>()) + " voxels\n";
        text += "  sha256           " + report["sha256"].get<std::string>() + "\n";
    }
    if (report.contains("table"))
        text += tableLine(report["table"]);
    for (const char* step : {"read", "statistics", "checksum", "table"})
        if (const std::string key = std::string(step) + "Seconds"; report.contains(key))
            text += secondsLine(step, report[key].get<double>());
    if (report.contains("error"))
        text += "  error            " + report["error"].get<std::string>() + "\n";
    return text + "  id               " + report["id"].get<std::string>() + "\n";
}

}  // namespace pdr::app
