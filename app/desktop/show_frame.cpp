#include "app/desktop/show_frame.h"

#include <QDate>
#include <QRegularExpression>
#include <cmath>

#include "app/desktop/annotating.h"
#include "app/desktop/look_text.h"
#include "app/desktop/show_message.h"
#include "render/accuracy/quality.h"
#include "ui/annotation/orientation_letters.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/room_text.h"
#include "ui/text/series_text.h"
#include "ui/text/status_text.h"
#include "ui/text/to_qt.h"
#include "ui/view/error_colours.h"

namespace pdr::app {
namespace {

/// Returns an image that refers to `bytes` and keeps the frame alive that holds them.
QImage imageOf(const std::shared_ptr<const Frame>& frame, const std::vector<std::uint8_t>& bytes, ivec2 size,
               QImage::Format format) {
    auto* kept = new std::shared_ptr<const Frame>(frame);
    const auto release = [](void* pointer) { delete static_cast<std::shared_ptr<const Frame>*>(pointer); };
    const qsizetype stride = qsizetype(bytes.size()) / size.y;
    return QImage(bytes.data(), size.x, size.y, stride, format, release, kept);
}

QImage pictureOf(const std::shared_ptr<const Frame>& frame) {
    return imageOf(frame, frame->rgba, frame->size, QImage::Format_RGBX8888);
}

/// Returns the error map in colours; null if the frame has none.
QImage errorMapOf(const std::shared_ptr<const Frame>& frame) {
    if (!frame->errorMap)
        return {};
    QImage map = imageOf(frame, frame->errorMap->bins, frame->errorMap->size, QImage::Format_Indexed8);
    map.setColorTable(ui::errorColours());
    return map;
}

/// Returns the remarks on a denoised image; nothing for another.
QStringList smoothedTexts(const Frame& frame) {
    return frame.smoothed ? ui::smoothedTexts(frame.smoothedError, frame.lostLines.size()) : QStringList();
}

/// Returns the lines that denoising has removed from the image; the film itself has them.
QList<QLineF> lostLinesOf(const Frame& frame) {
    QList<QLineF> lines;
    if (!frame.smoothed)
        return lines;
    for (const denoise::LostLine& line : frame.lostLines)
        lines << QLineF(double(line.begin.x), double(line.begin.y), double(line.end.x), double(line.end.y));
    return lines;
}

/// Returns a key shared by images that take about as long per pixel: device and look.
QString kindOf(const Frame& frame) {
    return QString::fromStdString(frame.device + "/" + frame.lookName);
}

double pixelsOf(const Frame& frame) {
    return double(frame.size.x) * frame.size.y;
}

/// Saves the time per pixel that planning quality took, for the next image of the kind.
void keepWhatItTook(Settings& settings, const Frame& frame) {
    for (const QualityStep& step : frame.steps)
        if (step.levels == kPlanningLevels && !step.atLeast())
            settings.keepPlanningSeconds(kindOf(frame), step.seconds.value / pixelsOf(frame));
}

/// Returns the time that the last image of the kind took per pixel, multiplied by the pixels of the whole film: a
/// coarse image has fewer.
std::optional<double> lastTime(const DesktopParts& parts, const Frame& frame) {
    const ivec2 film = parts.document.scene().film;
    const std::optional<double> perPixel = parts.settings.planningSeconds(kindOf(frame));
    return perPixel ? std::optional(*perPixel * film.x * film.y) : std::nullopt;
}

/// Estimates the cost of an image from the time that this one took, or else the last one of its kind.
std::optional<ui::PictureCost> costOf(const DesktopParts& parts, const Frame& frame) {
    const double error = frame.status.displayError;
    if (!frame.coarse && std::isfinite(error) && error > 0 && frame.seconds > 0)
        return ui::PictureCost{frame.seconds * error * error / pixelsOf(frame)};
    if (const std::optional<double> last = parts.settings.planningSeconds(kindOf(frame)))
        return ui::PictureCost{*last * kPlanningLevels * kPlanningLevels};
    return std::nullopt;
}

/// Returns a file name, "Bones-alone_A_2030-01-31": look, visible side, today. It contains nothing of the patient.
QString fileNameOf(const DesktopParts& parts, const Frame& frame) {
    static const QRegularExpression noLetters("[^\\w]+", QRegularExpression::UseUnicodePropertiesOption);
    QString look = nameText(parts.document.looks(), frame.lookName).replace(noLetters, "-");
    while (look.endsWith('-'))
        look.chop(1);
    const QString side = QString::fromStdString(ui::orientationLetters(-frame.camera.forward()));
    return QStringList{look, side, QDate::currentDate().toString(Qt::ISODate)}.join('_');
}

/// Returns remarks on what may mislead about the image: comparison modes, stretching and known bias; or that no bias is
/// known.
QStringList remarksOn(const DesktopParts& parts, const Frame& frame) {
    QStringList remarks{ui::comparisonText(frame.schedule, frame.estimator)};
    if (frame.region)
        remarks << ui::boxText(frame.region->status, !frame.region->reached, shownOf(frame).status);
    if (!frame.coarse)
        remarks << ui::unseenText(frame.status);
    remarks << smoothedTexts(frame);
    if (frame.smoothed && frame.smoothedError)
        remarks << ui::hiddenDetailTexts(*frame.smoothedError);
    remarks << ui::stretchedText(frame.size, parts.window.viewport().sizeInPixels());
    const std::vector<Bias> known = biases(frame.bias);
    for (const Bias& bias : known)
        if (bias.cause != BiasCause::smoothing)  // smoothedTexts() says more
            remarks << ui::inWords(bias.text);
    if (noneOfComputing(known))
        remarks << ui::MainWindow::tr("No known systematic error");
    remarks.removeAll({});
    return remarks;
}

ui::Holding holdingOf(const RenderBridge& bridge) {
    if (bridge.paused())
        return ui::Holding::paused;
    return bridge.reached() ? ui::Holding::reached : ui::Holding::no;
}

/// Returns the accuracy of the box while it gets all samples, else of the whole image.
ui::Accuracy accuracyOf(const DesktopParts& parts, const Frame& frame) {
    const ShownStatus shown = shownOf(frame);
    ui::Accuracy accuracy{shown.status,  frame.coarse,          shown.of,
                          frame.steps,   frame.seconds,         holdingOf(parts.bridge),
                          frame.history, lastTime(parts, frame)};
    if (shown.of == ErrorOf::denoised)
        accuracy.film = frame.status;
    if (!frame.region || frame.region->reached)
        return accuracy;
    accuracy.status = frame.region->status;
    accuracy.of = frame.region->of;
    accuracy.steps = frame.region->steps;
    accuracy.points = frame.region->history;
    accuracy.box = true;
    return accuracy;
}

/// Replaces the pixel's error by the level of its colour in the error map of the image that is shown.
LevelErrorsAt asMapped(LevelErrorsAt errors, const LevelErrorMap& map, QPointF place) {
    const ivec2 pixel =
        glm::clamp(ivec2(int(place.x() * map.size.x), int(place.y() * map.size.y)), ivec2(0), map.size - 1);
    const std::uint8_t bin = map.bins[std::size_t(pixel.y) * std::size_t(map.size.x) + std::size_t(pixel.x)];
    if (bin >= kFirstBin && bin <= kLastBin)
        errors.here = float(levelsOfBin(bin));
    return errors;
}

}  // namespace

void showNoPicture(const DesktopParts& parts, const QString& message) {
    parts.window.viewport().clearPicture();
    parts.window.viewport().setMessage(message);
    parts.window.foot().clear();
    parts.window.accuracy().clear();
    parts.window.setPictureAvailable(false);
}

void showFrame(const DesktopParts& parts, const std::shared_ptr<const Frame>& frame) {
    if (!frame->error.empty()) {
        showNoPicture(parts, ui::MainWindow::tr("No image"));
        return showFailure(parts, {frame->error, "", ""});
    }
    parts.window.viewport().setPicture({pictureOf(frame), frame->camera, annotationsOf(parts, *frame).texts.join('\n'),
                                        smoothedTexts(*frame).join('\n'), lostLinesOf(*frame),
                                        ui::previewText(shownOf(*frame), frame->stop.levels), errorMapOf(frame),
                                        shownOf(*frame).of == ErrorOf::beforeDenoising});
    parts.window.cut().setPicture(frame->camera, {frame->size.x, frame->size.y});
    parts.window.setPictureOffer(fileNameOf(parts, *frame), costOf(parts, *frame));
    parts.window.region().setPicture({frame->size.x, frame->size.y});
    parts.window.setPictureAvailable(true);
    parts.looks.setImageStands(true);
    keepWhatItTook(parts.settings, *frame);
    showStatus(parts);
}

void showStatus(const DesktopParts& parts) {
    const auto& frame = parts.bridge.lastFrame();
    if (!frame)
        return;
    const RenderBridge& bridge = parts.bridge;
    ui::Foot& foot = parts.window.foot();
    parts.window.setPaused(bridge.paused() || bridge.reached());
    const ui::Accuracy accuracy = accuracyOf(parts, *frame);
    const QString making = ui::makingText({QString::fromStdString(frame->device), frame->iterations, frame->efficiency,
                                           frame->status.samplesPerPixel, frame->iterationsPerSecond});
    foot.setAccuracy(accuracy);
    const QStringList remarks = remarksOn(parts, *frame);
    foot.setMaking(making);
    QStringList beside = remarks;
    for (const QString& text : smoothedTexts(*frame))  // they are shown on the image already
        beside.removeAll(text);
    if (parts.battery.rests())
        beside.prepend(ui::MainWindow::tr("Paused on battery (Space: continue)"));
    foot.setRemarks(beside);
    ui::AccuracyPanel& panel = parts.window.accuracy();
    panel.setAccuracy(accuracy, bridge.stop());
    panel.setBias(remarks);
    panel.setMaking(making);
    foot.setLimit(ui::gridText(parts.document.scene().volume->geometry().spacingMm()));
}

void showStop(const DesktopParts& parts, const StopRule& rule) {
    parts.window.foot().strip().setTarget(rule.levels);
    parts.window.accuracy().stop().setRule(rule);
    showStatus(parts);
}

void showErrorAt(const DesktopParts& parts, QPointF place, const LevelErrorsAt& errors) {
    const auto& frame = parts.bridge.lastFrame();
    if (!frame)
        return;
    const ErrorOf of = shownOf(*frame).of;
    if (frame->errorMap)
        return parts.window.viewport().showTip(place, ui::hereText(asMapped(errors, *frame->errorMap, place), of));
    parts.window.viewport().showTip(place,
                                    ui::hereText(errors, of == ErrorOf::denoised ? ErrorOf::beforeDenoising : of));
}

}  // namespace pdr::app
