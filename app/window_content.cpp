#include "app/window_content.h"

#include "app/caption.h"
#include "app/ledger_content.h"
#include "app/series_choice.h"
#include "render/accuracy/quality.h"
#include "ui/error_colours.h"
#include "ui/series_text.h"
#include "ui/status_text.h"
#include "ui/to_qt.h"

namespace pdr::app {
namespace {

/// A view of bytes; the image keeps the frame alive that holds them.
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

/// Null where the frame has none.
QImage errorMapOf(const std::shared_ptr<const Frame>& frame) {
    if (!frame->errorMap)
        return {};
    QImage map = imageOf(frame, frame->errorMap->bins, frame->errorMap->size, QImage::Format_Indexed8);
    map.setColorTable(ui::errorColours());
    return map;
}

/// What stands beside a smoothed picture; nothing beside another.
QStringList smoothedTexts(const Frame& frame) {
    return frame.smoothed ? ui::smoothedTexts(frame.smoothedError, frame.lostLines.size()) : QStringList();
}

/// Of the smoothed picture: the film itself has them.
QList<QLineF> lostLinesOf(const Frame& frame) {
    QList<QLineF> lines;
    if (!frame.smoothed)
        return lines;
    for (const denoise::LostLine& line : frame.lostLines)
        lines << QLineF(double(line.begin.x), double(line.begin.y), double(line.end.x), double(line.end.y));
    return lines;
}

/// Pictures that take about as long per pixel.
QString kindOf(const Frame& frame) {
    return QString::fromStdString(frame.device + "/" + frame.lookName);
}

double pixelsOf(const Frame& frame) {
    return double(frame.size.x) * frame.size.y;
}

/// For the next picture of the kind.
void keepWhatItTook(Settings& settings, const Frame& frame) {
    for (const QualityStep& step : frame.steps)
        if (step.levels == kPlanningLevels && !step.atLeast())
            settings.keepPlanningSeconds(kindOf(frame), step.seconds.value / pixelsOf(frame));
}

/// What the last picture of the kind took per pixel, for those of the whole view: a coarse one has fewer.
std::optional<double> lastTime(const DesktopParts& parts, const Frame& frame) {
    const QSize view = parts.window.viewport().sizeInPixels();
    const std::optional<double> perPixel = parts.settings.planningSeconds(kindOf(frame));
    return perPixel ? std::optional(*perPixel * view.width() * view.height()) : std::nullopt;
}

QString invitation() {
    return ui::MainWindow::tr("Drop a folder with a CT here, or press Ctrl+O");
}

/// The place of the picture, with a few words in it.
void showNoPicture(const DesktopParts& parts, const QString& message) {
    parts.window.viewport().clearPicture();
    parts.window.viewport().setMessage(message);
    parts.window.foot().clear();
    parts.window.accuracy().clear();
    parts.window.setPictureAvailable(false);
}

/// What the import remarked on the series, its voxels and its table, one note a line.
QString notesOn(const dicom::Series& series, const std::vector<dicom::Note>& ofPixels,
                const segment::HiddenTable& table) {
    QStringList lines;
    for (const auto* notes : {&series.verdict.notes, &ofPixels})
        for (const dicom::Note& note : *notes)
            lines << ui::sentence(note.text);
    if (const std::string text = segment::tableText(table); !text.empty())
        lines << QString::fromStdString(text);
    return lines.join('\n');
}

/// What makes the picture another one than it seems; or that nothing does.
QStringList remarksOn(const DesktopParts& parts, const Frame& frame) {
    QStringList remarks{ui::comparisonText(frame.schedule, frame.estimator)};
    if (frame.region)
        remarks << ui::boxText(frame.region->status, !frame.region->reached, frame.status);
    remarks << smoothedTexts(frame) << ui::stretchedText(frame.size, parts.window.viewport().sizeInPixels());
    const std::vector<Bias> known = biases(frame.bias);
    for (const Bias& bias : known)
        if (bias.cause != BiasCause::smoothing)  // more is said of that above
            remarks << QString::fromStdString(bias.text);
    if (noneOfComputing(known))
        remarks << ui::MainWindow::tr("No known bias in the computing");
    remarks.removeAll({});
    return remarks;
}

ui::Holding holdingOf(const RenderBridge& bridge) {
    if (bridge.paused())
        return ui::Holding::paused;
    return bridge.reached() ? ui::Holding::reached : ui::Holding::no;
}

/// Of the box as long as it gets all samples; else of the whole picture.
ui::Accuracy accuracyOf(const DesktopParts& parts, const Frame& frame) {
    ui::Accuracy accuracy{frame.status,  frame.coarse,          frame.smoothed,
                          frame.steps,   frame.seconds,         holdingOf(parts.bridge),
                          frame.history, lastTime(parts, frame)};
    if (!frame.region || frame.region->reached)
        return accuracy;
    accuracy.status = frame.region->status;
    accuracy.steps = frame.region->steps;
    accuracy.points = frame.region->history;
    accuracy.box = true;
    return accuracy;
}

}  // namespace

void showNothing(const DesktopParts& parts) {
    parts.picture.cancel();
    parts.document.close();
    parts.bridge.clear();
    parts.bridge.setRegion(std::nullopt);
    parts.window.setRegion(std::nullopt);
    parts.study.setVolume(nullptr);
    parts.window.tissue().setHistogram(nullptr);
    showNoPicture(parts, invitation());
    parts.window.setSubject({});
    parts.window.series().setNothingShown();
    showDocument(parts);
}

void showReading(const DesktopParts& parts, int index) {
    showNothing(parts);
    parts.import.loadSeries(index);
}

void showScan(const DesktopParts& parts, const dicom::ScanResult& scan, const QString& folder) {
    showNothing(parts);
    parts.window.message().clear();
    parts.window.setLastFolder(folder);
    parts.window.series().setScan(scan);
    if (const int first = firstLoadable(scan); first >= 0)
        return parts.import.loadSeries(first);
    parts.window.series().setCurrent(scan.series.empty() ? -1 : 0);
    Error error = nothingLoadable(scan).in(folder.toStdString());
    error.hint = "Open a folder with a CT series.";
    parts.window.message().showError(error);
}

void showVolume(const DesktopParts& parts, std::shared_ptr<const Volume> volume, int index,
                const segment::HiddenTable& table) {
    const dicom::Series& series = parts.import.scan().series[std::size_t(index)];
    parts.window.message().clear();
    if (const QString notes = notesOn(series, parts.import.loadNotes(), table); !notes.isEmpty())
        showNotice(parts, notes);
    if (table.body)
        parts.window.message().offer(ui::MainWindow::tr("Show"));
    parts.window.setSubject(ui::windowSubject(series));
    parts.window.series().setCurrent(index);
    showNoPicture(parts, ui::MainWindow::tr("Preparing the volume of %1...").arg(ui::windowSubject(series)));
    parts.study.setVolume(table.body ? table.body : volume);
    parts.document.open(std::move(volume), table);
}

void showProgress(const DesktopParts& parts, double fraction, const QString& step) {
    parts.window.status().setProgress(fraction, step);
    parts.window.viewport().setMessage(ui::sentence(step.toStdString()));
}

void showReadingEnded(const DesktopParts& parts) {
    parts.window.viewport().setMessage(invitation());
    parts.window.series().setCurrent(parts.window.series().current());
}

void showFailure(const DesktopParts& parts, const Error& error) {
    parts.window.message().showError(error);
}

void showSaved(const DesktopParts& parts, const QString& file) {
    parts.window.status().showForAWhile(ui::MainWindow::tr("saved as %1").arg(file));
}

void showNotice(const DesktopParts& parts, const QString& sentences) {
    parts.window.message().showError({sentences.toStdString(), "", ""});
}

void showFrame(const DesktopParts& parts, const std::shared_ptr<const Frame>& frame) {
    if (!frame->error.empty()) {
        showNoPicture(parts, ui::MainWindow::tr("No picture"));
        return showFailure(parts, {frame->error, "", ""});
    }
    parts.window.viewport().setPicture(
        {pictureOf(frame), frame->camera, QString::fromStdString(frame->lookName), smoothedTexts(*frame).join('\n'),
         lostLinesOf(*frame), captionOn(*frame, parts.bridge.captioned()), errorMapOf(frame), frame->smoothed});
    parts.window.setPictureAvailable(true);
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
    foot.setRemarks(remarks);
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
    parts.window.viewport().showTip(place, ui::hereText(errors, frame && frame->smoothed));
}

void showEffects(const DesktopParts& parts) {
    const auto& ledger = parts.bridge.lastLedger();
    if (!ledger || !parts.document.hasVolume())
        return parts.window.effects().setRows({});
    parts.window.effects().setRows(effectRows(*ledger, leanSetup(parts.document, *ledger).leftOut));
}

void leaveOutUnseen(const DesktopParts& parts) {
    if (const auto& ledger = parts.bridge.lastLedger(); ledger && parts.document.hasVolume())
        parts.document.setSetup(leanSetup(parts.document, *ledger).setup);
}

void pickTissue(const DesktopParts& parts, QPointF place) {
    if (parts.document.hasVolume())
        parts.study.pick(parts.document.scene(), place);
}

void makePicture(const DesktopParts& parts, const ui::PictureOrder& order) {
    if (!parts.document.hasVolume() || !order.size)
        return;
    Scene scene = parts.document.scene();
    scene.film = {order.size->width(), order.size->height()};
    parts.picture.make({scene, parts.document.display(), parts.bridge.captioned(), order.stop, order.file,
                        parts.bridge.anotherDevice()});
}

void cancelWhatRuns(const DesktopParts& parts) {
    if (parts.import.isRunning())
        parts.import.cancel();
    else
        parts.picture.cancel();
}

void showDocument(const DesktopParts& parts) {
    const Document& document = parts.document;
    const auto camera = document.hasVolume() ? std::optional(document.setup().camera) : std::nullopt;
    parts.window.viewport().setCamera(camera);
    if (document.setup().table == Table::shown)
        parts.window.message().withdraw();
    parts.window.setTable(document.setup().table == Table::shown, document.hasTable());
    parts.window.look().setPreset(document.preset());
    parts.window.look().setBrightness(document.setup().stops);
    parts.window.tissue().setTransferFunction(document.setup().look.transferFunction);
    parts.window.rendering().setEstimator(document.setup().estimator);
    parts.window.rendering().setSchedule(document.setup().schedule);
    parts.window.setSmoothed(document.smoothed());
    parts.window.setUndoAvailable(document.canUndo(), document.canRedo());
}

}  // namespace pdr::app
