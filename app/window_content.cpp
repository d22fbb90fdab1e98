#include "app/window_content.h"

#include "app/ledger_content.h"
#include "app/series_choice.h"
#include "render/film/health_text.h"
#include "render/prepare/warnings.h"
#include "ui/series_text.h"
#include "ui/status_text.h"
#include "ui/to_qt.h"

namespace pdr::app {
namespace {

/// A view of the frame's bytes; the image keeps the frame alive.
QImage imageOf(const std::shared_ptr<const Frame>& frame) {
    auto* kept = new std::shared_ptr<const Frame>(frame);
    const auto release = [](void* pointer) { delete static_cast<std::shared_ptr<const Frame>*>(pointer); };
    return QImage(frame->rgba.data(), frame->size.x, frame->size.y, frame->size.x * 4, QImage::Format_RGBX8888, release,
                  kept);
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

QString invitation() {
    return ui::MainWindow::tr("Drop a folder with a CT here, or press Ctrl+O");
}

/// The place of the picture, with a few words in it.
void showNoPicture(const DesktopParts& parts, const QString& message) {
    parts.window.viewport().clearPicture();
    parts.window.viewport().setMessage(message);
    parts.window.foot().clear();
    parts.window.setPictureAvailable(false);
}

/// What the import remarked on the series and its voxels, one sentence a line.
QString notesOn(const dicom::Series& series, const std::vector<dicom::Note>& ofPixels) {
    QStringList lines;
    for (const auto* notes : {&series.verdict.notes, &ofPixels})
        for (const dicom::Note& note : *notes)
            lines << ui::sentence(note.text);
    return lines.join('\n');
}

/// What makes the picture another one than it seems; or that nothing does.
QStringList remarksOn(const DesktopParts& parts, const Frame& frame) {
    const Scene& scene = parts.document.scene();
    QStringList remarks{ui::comparisonText(frame.schedule, frame.estimator)};
    remarks << smoothedTexts(frame) << ui::stretchedText(frame.size, parts.window.viewport().sizeInPixels());
    for (const std::string& line : healthLines(frame.status.health))
        remarks << QString::fromStdString(line);
    for (const Warning& warning : warnings(scene))
        remarks << QString::fromStdString(warning.text);
    remarks.removeAll({});
    if (remarks.isEmpty() && scene.filtering == Filtering::exact)
        remarks << ui::MainWindow::tr("No known bias in the computing");
    return remarks;
}

}  // namespace

void showNothing(const DesktopParts& parts) {
    parts.document.close();
    parts.bridge.clear();
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

void showVolume(const DesktopParts& parts, std::shared_ptr<const Volume> volume, int index) {
    const dicom::Series& series = parts.import.scan().series[std::size_t(index)];
    parts.window.message().clear();
    if (const QString notes = notesOn(series, parts.import.loadNotes()); !notes.isEmpty())
        showNotice(parts, notes);
    parts.window.setSubject(ui::windowSubject(series));
    parts.window.series().setCurrent(index);
    showNoPicture(parts, ui::MainWindow::tr("Preparing the volume of %1...").arg(ui::windowSubject(series)));
    parts.document.open(std::move(volume));
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

void showNotice(const DesktopParts& parts, const QString& sentences) {
    parts.window.message().showError({sentences.toStdString(), "", ""});
}

void showFrame(const DesktopParts& parts, const std::shared_ptr<const Frame>& frame) {
    if (!frame->error.empty()) {
        showNoPicture(parts, ui::MainWindow::tr("No picture"));
        return showFailure(parts, {frame->error, "", ""});
    }
    parts.window.viewport().setPicture({imageOf(frame), frame->camera, QString::fromStdString(frame->lookName),
                                        smoothedTexts(*frame).join('\n'), lostLinesOf(*frame)});
    parts.window.setPictureAvailable(true);
    showStatus(parts);
}

void showStatus(const DesktopParts& parts) {
    const auto& frame = parts.bridge.lastFrame();
    if (!frame)
        return;
    const RenderBridge& bridge = parts.bridge;
    ui::Foot& foot = parts.window.foot();
    parts.window.setPaused(bridge.paused() || bridge.reached());
    const ui::Holding holding = bridge.paused()    ? ui::Holding::paused
                                : bridge.reached() ? ui::Holding::reached
                                                   : ui::Holding::no;
    foot.setAccuracy({frame->status, frame->coarse, frame->smoothed, frame->steps, frame->seconds, holding});
    foot.setMaking(ui::makingText({QString::fromStdString(frame->device), frame->iterations, frame->efficiency,
                                   frame->status.samplesPerPixel, frame->iterationsPerSecond}));
    foot.setRemarks(remarksOn(parts, *frame));
    foot.setLimit(ui::gridText(parts.document.scene().volume->geometry().spacingMm()));
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

void showDocument(const DesktopParts& parts) {
    const Document& document = parts.document;
    const auto camera = document.hasVolume() ? std::optional(document.setup().camera) : std::nullopt;
    parts.window.viewport().setCamera(camera);
    parts.window.look().setPreset(document.preset());
    parts.window.look().setBrightness(document.setup().stops);
    parts.window.rendering().setEstimator(document.setup().estimator);
    parts.window.rendering().setSchedule(document.setup().schedule);
    parts.window.setSmoothed(document.smoothed());
    parts.window.setUndoAvailable(document.canUndo(), document.canRedo());
}

}  // namespace pdr::app
