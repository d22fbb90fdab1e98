#include "app/cli/accuracy/accuracy_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <cstdio>

#include "render/film/levels_text.h"

namespace pdr::app {
namespace {

QJsonValue valueOr(const std::optional<double>& value) {
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonObject stepObject(const AccuracyStep& step) {
    return {{"samples", double(step.samples)},
            {"seconds", step.seconds},
            {"relativeError", step.error.relative},
            {"levels", step.error.levels},
            {"stated", valueOr(step.stated)},
            {"atMost", valueOr(step.atMost)},
            {"picture", step.picture.empty() ? QJsonValue() : QJsonValue(step.picture.c_str())}};
}

QJsonObject curveObject(const AccuracyCurve& curve) {
    QJsonArray steps;
    for (const AccuracyStep& step : curve.steps)
        steps.append(stepObject(step));
    QJsonObject secondsTo;
    for (const double levels : kLadder)
        secondsTo.insert(levelsText(levels).c_str(), valueOr(secondsToReach(levels, curve)));
    return {{"name", curve.name.c_str()}, {"bias", curve.bias.c_str()}, {"steps", steps}, {"secondsTo", secondsTo}};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

}  // namespace

std::string csvText(const AccuracyReport& report) {
    std::string text = "way,samples,seconds,relative error,levels,stated,at most\n";
    for (const AccuracyCurve& curve : report.curves)
        for (const AccuracyStep& step : curve.steps) {
            text.append("\"").append(curve.name).append("\",").append(std::to_string(step.samples));
            for (const std::optional<double>& value : {std::optional(step.seconds), std::optional(step.error.relative),
                                                       std::optional(step.error.levels), step.stated, step.atMost})
                text.append(",").append(value ? number(*value) : std::string());
            text += '\n';
        }
    return text;
}

std::string jsonText(const AccuracyReport& report) {
    QJsonArray ways;
    for (const AccuracyCurve& curve : report.curves)
        ways.append(curveObject(curve));
    QJsonObject reference{{"samples", double(report.referenceSamples)}};
    if (report.referenceError) {
        reference.insert("levels", report.referenceError->levels);
        reference.insert("atMost", report.referenceError->levelsAtMost);
    }
    const QJsonObject object{{"width", report.size.x},
                             {"height", report.size.y},
                             {"model", report.model.c_str()},
                             {"device", report.device.c_str()},
                             {"program", report.program.c_str()},
                             {"seed", std::to_string(report.seed).c_str()},
                             {"complete", report.complete},
                             {"reference", reference},
                             {"ways", ways}};
    return QJsonDocument(object).toJson().toStdString();
}

std::string ladderText(const AccuracyCurve& curve) {
    std::string text;
    for (const double levels : kLadder)
        if (const auto seconds = secondsToReach(levels, curve)) {
            char one[64];
            std::snprintf(one, sizeof one, "%s±%s in %.2g s", text.empty() ? "" : ", ", levelsText(levels).c_str(),
                          *seconds);
            text += one;
        }
    return text.empty() ? "not yet within ±32" : text;
}

}  // namespace pdr::app
