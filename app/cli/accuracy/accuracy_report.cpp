#include "app/cli/accuracy/accuracy_report.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "app/cli/render/bias_report.h"
#include "render/film/levels_text.h"

namespace pdr::app {
namespace {

QJsonValue valueOr(const std::optional<double>& value) {
    return value ? QJsonValue(*value) : QJsonValue();
}

QJsonValue foretoldValue(const std::optional<Foretold>& foretold) {
    if (!foretold)
        return {};
    const QJsonValue high = std::isinf(foretold->high) ? QJsonValue() : QJsonValue(foretold->high);
    return QJsonObject{{"value", foretold->value}, {"low", foretold->low}, {"high", high}};
}

QJsonObject stepObject(const AccuracyStep& step) {
    return {{"samples", double(step.samples)},
            {"seconds", step.seconds},
            {"relativeError", step.error.relative},
            {"levels", step.error.levels},
            {"stated", valueOr(step.stated)},
            {"atMost", valueOr(step.atMost)},
            {"foretoldAtQuarter", foretoldValue(step.foretoldAtQuarter)},
            {"foretoldAtSixteenth", foretoldValue(step.foretoldAtSixteenth)},
            {"picture", step.image.empty() ? QJsonValue() : QJsonValue(step.image.c_str())}};
}

QJsonObject curveObject(const AccuracyCurve& curve) {
    QJsonArray steps;
    for (const AccuracyStep& step : curve.steps)
        steps.append(stepObject(step));
    QJsonObject secondsTo;
    for (const double levels : kLadder)
        secondsTo.insert(levelsText(levels).c_str(), valueOr(secondsToReach(levels, curve)));
    QJsonValue measured;
    if (const auto& bias = curve.measuredBias)
        measured =
            QJsonObject{{"brightness", intervalObject(bias->brightness)}, {"levels", intervalObject(bias->levels)}};
    return {{"name", curve.name.c_str()},
            {"bias", curve.bias.c_str()},
            {"missing", curve.missing.c_str()},
            {"measuredBias", measured},
            {"steps", steps},
            {"secondsTo", secondsTo}};
}

/// Returns an object with the image's name, reference and ways.
QJsonObject imageObject(const AccuracyImage& image) {
    QJsonArray ways;
    for (const AccuracyCurve& curve : image.curves)
        ways.append(curveObject(curve));
    QJsonObject reference{{"samples", double(image.referenceSamples)}};
    if (image.referenceError) {
        reference.insert("levels", image.referenceError->levels);
        reference.insert("atMost", image.referenceError->levelsAtMost);
    }
    return {{"name", image.name.c_str()}, {"reference", reference}, {"ways", ways}};
}

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.6g", value);
    return text;
}

}  // namespace

std::string csvText(const AccuracyReport& report) {
    std::string text = "picture,way,samples,seconds,relative error,levels,stated,at most\n";
    const auto add = [&](const AccuracyImage& image) {
        for (const AccuracyCurve& curve : image.curves)
            for (const AccuracyStep& step : curve.steps) {
                text += "\"" + image.name + "\",\"" + curve.name + "\"," + std::to_string(step.samples);
                for (const std::optional<double>& value :
                     {std::optional(step.seconds), std::optional(step.error.relative), std::optional(step.error.levels),
                      step.stated, step.atMost})
                    text.append(",").append(value ? number(*value) : std::string());
                text += '\n';
            }
    };
    add(report.scene);
    std::ranges::for_each(report.others, add);
    return text;
}

std::string jsonText(const AccuracyReport& report) {
    QJsonArray others;
    for (const AccuracyImage& other : report.others)
        others.append(imageObject(other));
    QJsonObject object = imageObject(report.scene);
    object.insert("width", report.size.x);
    object.insert("height", report.size.y);
    object.insert("model", report.model.c_str());
    object.insert("device", report.device.c_str());
    object.insert("program", report.program.c_str());
    object.insert("seed", std::to_string(report.seed).c_str());
    object.insert("complete", report.complete);
    object.insert("others", others);
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
