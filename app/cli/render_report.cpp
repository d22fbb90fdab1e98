#include "app/cli/render_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/cli/progress_line.h"

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
        case StopReason::interrupted:
            break;
    }
    return "interrupted";
}

double samplesPerSecond(const RenderReport& report) {
    const double samples = double(report.result.film.samplesPerPixel) * report.size.x * report.size.y;
    return samples / std::max(report.result.seconds, 1e-9);
}

}  // namespace

std::string jsonText(const RenderReport& report) {
    QJsonArray outputs;
    for (const auto& path : report.outputs)
        outputs.append(QString::fromStdString(path.string()));
    const FilmStatus& film = report.result.film;
    const QJsonObject object{
        {"outputs", outputs},
        {"width", report.size.x},
        {"height", report.size.y},
        {"samplesPerPixel", double(film.samplesPerPixel)},
        {"rejectedSamples", double(film.rejectedSamples)},
        {"seconds", report.result.seconds},
        {"samplesPerSecond", samplesPerSecond(report)},
        {"relativeError", std::isfinite(film.relativeError) ? QJsonValue(film.relativeError) : QJsonValue()},
        {"meanLuminance", film.meanLuminance},
        {"stoppedBy", reasonWord(report.result.reason)},
        {"device", QString::fromStdString(report.device.name)},
        {"seed", QString::number(report.seed)},
    };
    return QJsonDocument(object).toJson().toStdString();
}

std::string plainText(const RenderReport& report) {
    const FilmStatus& film = report.result.film;
    std::ostringstream out;
    out.precision(3);
    out << report.size.x << " x " << report.size.y << " pixels, " << film.samplesPerPixel << " samples per pixel in "
        << report.result.seconds << " s (" << samplesPerSecond(report) / 1e6 << " million samples per second) on "
        << report.device.name << ", " << report.device.details << "\n"
        << "remaining error: " << errorText(film.relativeError) << " of the mean brightness\n";
    if (film.rejectedSamples > 0)
        out << "left out: " << film.rejectedSamples << " samples that were no numbers\n";
    for (const auto& path : report.outputs)
        out << "written: " << path.string() << "\n";
    return out.str();
}

}  // namespace pdr::app
