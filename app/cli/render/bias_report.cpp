#include "app/cli/render/bias_report.h"

#include <QString>

namespace pdr::app {
namespace {

QJsonObject biasObject(const Bias& bias) {
    const auto known = [](const std::optional<double>& value) { return value ? QJsonValue(*value) : QJsonValue(); };
    QJsonObject facts{{"cause", biasName(bias.cause)},
                      {"ofComputing", isOfComputing(bias.cause)},
                      {"text", QString::fromStdString(bias.text)},
                      {"brightness", QJsonValue()},
                      {"levels", QJsonValue()},
                      {"levelsAtMost", known(bias.levelsAtMost)},
                      {"shareAtMost", known(bias.shareAtMost)}};
    if (bias.measured) {
        facts["brightness"] = intervalObject(bias.measured->brightness);
        facts["levels"] = intervalObject(bias.measured->levels);
    }
    return facts;
}

}  // namespace

QJsonObject intervalObject(const Between& between) {
    return {{"value", between.value}, {"low", between.low}, {"high", between.high}};
}

QJsonArray biasArray(const std::vector<Bias>& biases) {
    QJsonArray all;
    for (const Bias& bias : biases)
        all.append(biasObject(bias));
    return all;
}

}  // namespace pdr::app
