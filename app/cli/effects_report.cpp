#include "app/cli/effects_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>

namespace pdr::app {
namespace {

QJsonObject bandObject(const CostBand& band) {
    return {{"low", band.low}, {"median", band.middle}, {"high", band.high}};
}

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace

std::string verdictText(const TriedEffect& tried) {
    if (!tried.effect.needed)
        return "off";
    const bool idle = tried.effect.couldBeLeftOut || (tried.trial && tried.trial->levels < kNoLevels);
    return idle ? "could be left out" : "needed";
}

std::string plainText(const EffectsReport& report) {
    constexpr const char* kRow = "%-24s %-18s %-26s %7s  %s\n";
    std::string text =
        line("%d x %d pixels on %s, %s; ms: processor time per iteration, median (smallest to largest of six)\n\n",
             report.film.x, report.film.y, report.device.name.c_str(), report.device.details.c_str());
    text += line(kRow, "effect", "", "ms", "levels", "because");
    for (const TriedEffect& tried : report.effects)
        text += line(kRow, tried.effect.name.c_str(), verdictText(tried).c_str(),
                     tried.trial ? costText(tried.trial->milliseconds).c_str() : "",
                     tried.trial ? line("%.2f", tried.trial->levels).c_str() : "", tried.effect.reason.c_str());
    text += line("\n%-24s %s\n", "model", "ms");
    for (const TriedModel& tried : report.models)
        text += line("%-24s %s%s\n", modelName(tried.model), costText(tried.milliseconds).c_str(),
                     tried.model == report.model ? "  (this one)" : "");
    return text;
}

std::string jsonText(const EffectsReport& report) {
    QJsonArray effects, models;
    for (const TriedEffect& tried : report.effects)
        effects.append(QJsonObject{
            {"name", tried.effect.name.c_str()},
            {"verdict", verdictText(tried).c_str()},
            {"reason", tried.effect.reason.c_str()},
            {"milliseconds", tried.trial ? QJsonValue(bandObject(tried.trial->milliseconds)) : QJsonValue()},
            {"levels", tried.trial ? QJsonValue(tried.trial->levels) : QJsonValue()}});
    for (const TriedModel& tried : report.models)
        models.append(QJsonObject{{"name", modelName(tried.model)}, {"milliseconds", bandObject(tried.milliseconds)}});
    const QJsonObject object{
        {"width", report.film.x},           {"height", report.film.y}, {"device", report.device.name.c_str()},
        {"model", modelName(report.model)}, {"effects", effects},      {"models", models}};
    return QJsonDocument(object).toJson().toStdString();
}

}  // namespace pdr::app
