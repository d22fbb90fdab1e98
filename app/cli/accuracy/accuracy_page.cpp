#include "app/cli/accuracy/accuracy_page.h"

#include <QFile>
#include <QString>

#include <cmath>

#include "app/cli/accuracy/accuracy_plot.h"
#include "app/cli/progress_line.h"
#include "render/accuracy/bias_text.h"
#include "render/film/levels_text.h"

namespace pdr::app {
namespace {

constexpr const char* kHead =
    "<!DOCTYPE html><html lang='en'><head><meta charset='utf-8'><title>What accuracy costs</title><style>"
    "body{font-family:sans-serif;max-width:1000px;margin:2em auto;padding:0 1em;color:#111;background:#fff}"
    "table{border-collapse:collapse}td,th{padding:.2em .8em;text-align:right;border-bottom:1px solid #ddd}"
    "td:first-child,th:first-child,.ladder td{text-align:left}figure{display:inline-block;margin:.3em}"
    "figure img{width:300px;background:#000}figcaption{font-size:.85em}</style></head><body>";

QString levels(const std::optional<double>& value) {
    return value ? "±" + QString::fromStdString(levelsText(*value)) : QString("-");
}

QString referenceText(const AccuracyImage& image) {
    QString text = QString("an image of %1 samples a pixel with other random numbers").arg(image.referenceSamples);
    if (image.referenceError)
        text += QString(", which is itself within %1, at most %2: what is smaller than that cannot be told")
                    .arg(levels(image.referenceError->levels), levels(image.referenceError->levelsAtMost));
    return text;
}

QString heading(const AccuracyReport& report) {
    QString text = QString(
                       "<h1>What accuracy costs</h1><p>%1 × %2 pixels, model %3, %4, %5, seed %6. An error of ±8 "
                       "means that 95 % of the tissue is shown within 8 of 255 grey levels of %7. Not for diagnostic "
                       "use.</p>")
                       .arg(report.size.x)
                       .arg(report.size.y)
                       .arg(report.model.c_str(), report.device.c_str(), report.program.c_str())
                       .arg(report.seed)
                       .arg(referenceText(report.scene));
    if (!report.complete)
        text += "<p><strong>Interrupted: what follows is what was measured until then.</strong></p>";
    return text;
}

/// Returns a phrase that says until when `way` has the smaller error. `plain`: the image as it is.
QString crossingText(const AccuracyCurve& way, const AccuracyCurve& plain) {
    const auto until = betterUntil(way, plain);
    if (!until)
        return "never closer to the truth than the image as it is, in the same time";
    if (std::isinf(*until))
        return "closer to the truth than the image as it is, until the time was up";
    return QString("closer to the truth than the image as it is until %1 s, never after").arg(*until, 0, 'g', 2);
}

QString ladder(const AccuracyImage& image) {
    QString text = "<table class='ladder'><tr><th>way</th><th>within reach</th></tr>";
    const auto row = [&](const QString& left, const QString& right) {
        text += "<tr><td>" + left + "</td><td>" + right + "</td></tr>";
    };
    for (std::size_t i = 0; i < image.curves.size(); ++i) {
        const AccuracyCurve& curve = image.curves[i];
        row(QString("<span style='color:%1'>■</span> %2").arg(curveColour(i), QString::fromStdString(curve.name)),
            QString::fromStdString(ladderText(curve)));
        if (curve.measuredBias)
            row({}, QString::fromStdString("bias: " + measuredText(*curve.measuredBias)));
        if (!curve.bias.empty() && i > 0)
            row({}, QString("biased (%1): %2")
                        .arg(QString::fromStdString(curve.bias), crossingText(curve, image.curves[0])));
        if (!curve.missing.empty())
            row({}, QString("may lack %1; %2")
                        .arg(QString::fromStdString(curve.missing), crossingText(curve, image.curves[0])));
    }
    return text + "</table>";
}

QString table(const AccuracyImage& image) {
    QString text =
        "<table><tr><th>way</th><th>samples</th><th>seconds</th><th>error</th><th>stated</th><th>at most</th>"
        "</tr>";
    for (const AccuracyCurve& curve : image.curves)
        for (const AccuracyStep& step : curve.steps)
            text += QString("<tr><td>%1</td><td>%2</td><td>%3</td><td>%4</td><td>%5</td><td>%6</td></tr>")
                        .arg(QString::fromStdString(curve.name))
                        .arg(step.samples)
                        .arg(step.seconds, 0, 'g', 3)
                        .arg(levels(step.error.levels), levels(step.stated), levels(step.atMost));
    return text + "</table>";
}

QString foretoldText(const std::optional<Foretold>& foretold) {
    const auto seconds = [](double value) { return QString::number(value, 'g', 3); };
    if (!foretold)
        return "-";
    if (std::isinf(foretold->high))
        return "at least " + seconds(foretold->low) + " s";
    return QString("%1 s (%2 to %3)").arg(seconds(foretold->value), seconds(foretold->low), seconds(foretold->high));
}

/// Returns a table of the times that the program predicted early in the rendering and the measured ones.
QString prophecies(const AccuracyCurve& curve) {
    QString text =
        "<table><tr><th>stated error</th><th>reached after</th><th>foretold at 1/4 of the samples</th>"
        "<th>at 1/16</th></tr>";
    for (const AccuracyStep& step : curve.steps)
        if (step.foretoldAtQuarter)
            text += QString("<tr><td>%1</td><td>%2 s</td><td>%3</td><td>%4</td></tr>")
                        .arg(levels(step.stated))
                        .arg(step.seconds, 0, 'g', 3)
                        .arg(foretoldText(step.foretoldAtQuarter), foretoldText(step.foretoldAtSixteenth));
    return text + "</table>";
}

QString otherImage(const AccuracyImage& other) {
    return "<h3>" + QString::fromStdString(other.name) + "</h3><p>Against " + referenceText(other) + ".</p>" +
           ladder(other);
}

QString figure(const AccuracyStep& step, const std::filesystem::path& images) {
    QFile file(QString::fromStdString((images / step.image).string()));
    if (!file.open(QIODevice::ReadOnly))
        return {};
    return QString(
               "<figure><img alt='' src='data:image/png;base64,%1'><figcaption>%2 s, %3: %4</figcaption>"
               "</figure>")
        .arg(QString::fromLatin1(file.readAll().toBase64()))
        .arg(step.seconds, 0, 'g', 2)
        .arg(QString::fromStdString(samplesText(step.samples)), levels(step.error.levels));
}

QString gallery(const AccuracyCurve& curve, const std::filesystem::path& images) {
    QString text = "<h2>" + QString::fromStdString(curve.name) + "</h2>";
    for (const AccuracyStep& step : curve.steps)
        if (!step.image.empty())
            text += figure(step, images);
    return text;
}

}  // namespace

std::string plotText(const AccuracyImage& image) {
    const auto floor = image.referenceError ? std::optional(image.referenceError->levels) : std::nullopt;
    return accuracyPlot(image.curves, floor).toStdString();
}

std::string pageText(const AccuracyReport& report, const std::filesystem::path& images) {
    const AccuracyImage& scene = report.scene;
    QString text = kHead + heading(report) + "<h2>How soon</h2>" + ladder(scene) +
                   "<h2>Error against time</h2><p>Lines with dots: measured. Dashed: what the program says of itself. "
                   "Dotted: the root of the time. Smoothing "
                   "itself takes a tenth of a second or two more.</p>" +
                   QString::fromStdString(plotText(scene));
    if (!scene.curves.empty())
        text += "<h2>Foretold and come true</h2>" + prophecies(scene.curves[0]);
    if (!report.others.empty())
        text += "<h2>Other images of the same anatomy</h2><p>Each has a truth of its own.</p>";
    for (const AccuracyImage& other : report.others)
        text += otherImage(other);
    text += "<h2>All steps</h2>" + table(scene);
    for (std::size_t i = 0; i < std::min<std::size_t>(2, scene.curves.size()); ++i)
        text += gallery(scene.curves[i], images);
    return (text + "</body></html>\n").toStdString();
}

}  // namespace pdr::app
