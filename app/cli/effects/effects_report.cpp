#include "app/cli/effects/effects_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>

#include "render/accuracy/effect_cost_text.h"

namespace pdr::app {
namespace {

QJsonObject object(const CostBand& band) {
    return {{"low", band.low}, {"median", band.middle}, {"high", band.high}};
}

QJsonObject object(const Foretold& number) {
    return {{"value", number.value}, {"low", number.low}, {"high", number.high}};
}

template <class... Values>
std::string line(const char* format, Values... values) {
    char text[512];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

constexpr const char* kRow = "%-24s %-18s %-22s %-18s %-22s %-22s %-20s %s\n";

std::string row(const TriedEffect& tried) {
    const std::string name = tried.effect.name, verdict = verdictText(tried), reason = tried.effect.reason;
    if (!tried.trial)
        return line(kRow, name.c_str(), verdict.c_str(), "", "", "", "", "", reason.c_str());
    const EffectTrial& trial = *tried.trial;
    return line(kRow, name.c_str(), verdict.c_str(), costText(trial.milliseconds).c_str(),
                shareText(trial.share).c_str(), levelsText(trial.change.mean).c_str(),
                levelsText(trial.change.ninetyFifth).c_str(), trial.time ? timeLeftText(*trial.time).c_str() : "?",
                reason.c_str());
}

QJsonObject object(const TriedEffect& tried) {
    QJsonObject effect{{"name", tried.effect.name.c_str()},
                       {"verdict", verdictText(tried).c_str()},
                       {"reason", tried.effect.reason.c_str()}};
    for (const char* figure : {"milliseconds", "share", "meanLevels", "levels95", "timeWithout"})
        effect[figure] = QJsonValue();
    if (!tried.trial)
        return effect;
    effect["milliseconds"] = object(tried.trial->milliseconds);
    effect["share"] = object(tried.trial->share);
    effect["meanLevels"] = object(tried.trial->change.mean);
    effect["levels95"] = object(tried.trial->change.ninetyFifth);
    if (tried.trial->time)
        effect["timeWithout"] = object(*tried.trial->time);
    return effect;
}

}  // namespace

std::string verdictText(const TriedEffect& tried) {
    if (!tried.effect.needed)
        return tried.effect.bringIn ? "left out" : "off";
    return tried.effect.couldBeLeftOut || tried.couldBeLeftOut() ? "could be left out" : "needed";
}

std::string plainText(const EffectsReport& report) {
    const EffectCosts& effectCosts = report.effectCosts;
    std::string text =
        line("%d x %d pixels on %s, %s, %.0f s of processor time\n", effectCosts.film.x, effectCosts.film.y,
             effectCosts.device.name.c_str(), effectCosts.device.details.c_str(), effectCosts.seconds);
    text +=
        "ms and share: of an iteration, median (smallest to largest of six); change: of the image without it, in\n"
        "levels of 255, mean and what 95 % stay below; time: to any target without it (95 % interval)\n\n";
    text += line(kRow, "effect", "", "ms", "share", "mean change", "95 % below", "time without", "because");
    for (const TriedEffect& tried : effectCosts.effects)
        text += row(tried);
    text += line("\n%-24s %s\n", "model", "ms");
    for (const TriedModel& tried : report.models)
        text += line("%-24s %s%s\n", modelName(tried.model), costText(tried.milliseconds).c_str(),
                     tried.model == effectCosts.model ? "  (this one)" : "");
    return text;
}

std::string jsonText(const EffectsReport& report) {
    const EffectCosts& effectCosts = report.effectCosts;
    QJsonArray effects, models;
    for (const TriedEffect& tried : effectCosts.effects)
        effects.append(object(tried));
    for (const TriedModel& tried : report.models)
        models.append(QJsonObject{{"name", modelName(tried.model)}, {"milliseconds", object(tried.milliseconds)}});
    const QJsonObject all{{"width", effectCosts.film.x},
                          {"height", effectCosts.film.y},
                          {"device", effectCosts.device.name.c_str()},
                          {"model", modelName(effectCosts.model)},
                          {"seconds", effectCosts.seconds},
                          {"effects", effects},
                          {"models", models}};
    return QJsonDocument(all).toJson().toStdString();
}

}  // namespace pdr::app
