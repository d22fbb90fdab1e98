#include "app/cli/render/render_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/cli/error_text.h"
#include "app/cli/progress_line.h"
#include "app/cli/render/bias_report.h"

namespace pdr::app {
namespace {

const char* reasonWord(StopReason reason) {
    switch (reason) {
        case StopReason::samples:
            return "samples";
        case StopReason::seconds:
            return "seconds";
        case StopReason::error:
            return "error";
        case StopReason::levels:
            return "levels";
        case StopReason::interrupted:
            break;
    }
    return "interrupted";
}

/// Returns for each fault how often it happened and, if it did, the first sample, which can be replayed.
QJsonObject healthObject(const Health& health, int width) {
    QJsonObject object;
    for (int i = 0; i < kFaults; ++i) {
        const FaultCount& fault = health.faults[i];
        QJsonObject facts{{"count", double(fault.count)}};
        if (fault.count > 0)
            facts["first"] = QJsonObject{
                {"x", int(fault.pixel % width)}, {"y", int(fault.pixel / width)}, {"sample", double(fault.sample)}};
        object[kFaultNames[i]] = facts;
    }
    return object;
}

QJsonValue nodesValue(const NodeChecks& checks) {
    if (checks.results == 0)
        return {};
    return QJsonObject{{"tiles", double(checks.results)},
                       {"checkedShare", checks.share()},
                       {"foundOneIn20", checks.foundWith(20)},
                       {"foundOneIn200", checks.foundWith(200)}};
}

std::string replayArguments(const FaultCount& fault, const RenderReport& report) {
    return "--size " + std::to_string(report.size.x) + "x" + std::to_string(report.size.y) + " --seed " +
           std::to_string(report.seed) + " --pixel " + std::to_string(fault.pixel % report.size.x) + "," +
           std::to_string(fault.pixel / report.size.x) + " --sample " + std::to_string(fault.sample);
}

/// Returns `value`, or null if it is not finite: JSON has no infinity.
QJsonValue known(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue();
}

double samplesPerSecond(const RenderReport& report) {
    const double samples = report.result.film.meanSamplesPerPixel * report.size.x * report.size.y;
    return samples / std::max(report.result.seconds, 1e-9);
}

}  // namespace

std::string jsonText(const RenderReport& report) {
    QJsonArray outputs;
    for (const auto& path : report.outputs)
        outputs.append(QString::fromStdString(path.string()));
    QJsonArray warnings;
    for (const Warning& warning : report.warnings)
        warnings.append(QString::fromStdString(warning.name));
    const FilmStatus& film = report.result.film;
    const QJsonObject object{
        {"outputs", outputs},
        {"width", report.size.x},
        {"height", report.size.y},
        {"samplesPerPixel", double(film.samplesPerPixel)},
        {"meanSamplesPerPixel", film.meanSamplesPerPixel},
        {"mostSamplesPerPixel", double(film.mostSamplesPerPixel)},
        {"nodes", nodesValue(report.checks)},
        {"rejectedSamples", double(film.health.rejected())},
        {"warnings", warnings},
        {"biases", biasArray(report.biases)},
        {"health", healthObject(film.health, report.size.x)},
        {"seconds", report.result.seconds},
        {"samplesPerSecond", samplesPerSecond(report)},
        {"relativeError", known(film.relativeError)},
        {"displayError", known(film.displayError)},
        {"tissuePixels", double(film.tissuePixels)},
        {"unseenTissue", film.unseenTissue},
        {"unseenShare", film.unseenShare},
        {"meanLuminance", film.meanLuminance},
        {"stoppedBy", reasonWord(report.result.reason)},
        {"device", QString::fromStdString(report.device.name)},
        {"seed", QString::number(report.seed)},
    };
    return QJsonDocument(object).toJson().toStdString();
}

std::string plainText(const RenderReport& report) {
    const FilmStatus& film = report.result.film;
    const std::uint64_t most = std::max(film.samplesPerPixel, film.mostSamplesPerPixel);
    const std::string fewest = most > film.samplesPerPixel ? std::to_string(film.samplesPerPixel) + " to " : "";
    std::ostringstream out;
    out.precision(3);
    out << report.size.x << " x " << report.size.y << " pixels, " << fewest << samplesText(most) << " in "
        << report.result.seconds << " s (" << samplesPerSecond(report) / 1e6 << " million samples per second) on "
        << report.device.name << ", " << report.device.details << "\n"
        << errorSentence(film) << "\n";
    for (const Bias& bias : report.biases) {
        out << bias.text;
        if (bias.fault)
            out << "; the first: pdrender-cli replay ... " << replayArguments(film.health.of(*bias.fault), report);
        out << "\n";
    }
    if (noneOfComputing(report.biases))
        out << "no known systematic error\n";
    if (report.checks.results > 0)
        out << checksText(report.checks) << "\n";
    for (const auto& path : report.outputs)
        out << "written: " << path.string() << "\n";
    return out.str();
}

}  // namespace pdr::app
