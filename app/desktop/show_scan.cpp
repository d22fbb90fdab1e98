#include "app/desktop/show_scan.h"

#include "app/desktop/show_document.h"
#include "app/desktop/show_frame.h"
#include "app/desktop/show_message.h"
#include "app/scan/series_choice.h"
#include "ui/text/room_text.h"
#include "ui/text/series_text.h"

namespace pdr::app {
namespace {

/// Returns the import's notes on a series and its table, one per line.
QString notesOn(const std::vector<dicom::Note>& notes, const segment::HiddenTable& table) {
    QStringList lines;
    for (const dicom::Note& note : notes)
        lines << ui::sentence(note.text);
    if (const Text text = segment::tableText(table); !text.empty())
        lines << ui::inWords(text);
    return lines.join('\n');
}

}  // namespace

void letGoOfVolume(const DesktopParts& parts) {
    parts.said = {};
    parts.picture.cancel();
    parts.masks.cancel();
    parts.modelTrial.cancel();
    parts.bridge.clear();
    parts.study.setVolume(nullptr);
    parts.looks.forget();
    parts.window.tissue().setHistogram(nullptr);
}

void showNothing(const DesktopParts& parts) {
    parts.document.close();
    parts.bridge.setRegion(std::nullopt);
    parts.window.setRegion(std::nullopt);
    parts.looks.setImageStands(false);
    showNoPicture(parts, {});
    parts.window.setStartShown(true);
    parts.window.setChoosing(false);
    parts.seriesPictures.cancel();
    parts.window.setSubject({});
    parts.window.setPatient({});
    parts.window.series().setNothingShown();
    showDocument(parts);
}

void showScan(const DesktopParts& parts, const dicom::ScanResult& scan, const QString& folder) {
    showNothing(parts);
    parts.window.message().clear();
    parts.window.setLastFolder(folder);
    parts.window.series().setScan(scan);
    parts.settings.keepFolder(folder);
    showRecentFolders(parts);
    if (const int only = onlyLoadable(scan); only >= 0)
        return parts.import.loadSeries(only);
    parts.window.setChoosing(true);
    parts.window.setStartShown(false);
    parts.seriesPictures.make(scan);
    if (firstLoadable(scan) >= 0)
        return parts.window.viewport().setMessage(ui::MainWindow::tr("Choose a series from the list on the left."));
    parts.window.series().setCurrent(scan.series.empty() ? -1 : 0);
    Error error = nothingLoadable(scan).in(folder.toStdString());
    error.hint = phrase("Open a folder with a CT series.");
    parts.window.message().showError(error);
    parts.window.viewport().setMessage(ui::MainWindow::tr("No series here can be shown. The list says why."));
}

void showRecentFolders(const DesktopParts& parts) {
    parts.window.setRecentFolders(parts.settings.recentFolders(), parts.settings.remembersFolders());
}

void showReading(const DesktopParts& parts, int index) {
    showNothing(parts);
    parts.import.loadSeries(index);
}

void showVolume(const DesktopParts& parts, std::shared_ptr<const Volume> volume, int index,
                const segment::HiddenTable& table, const segment::Findings& findings,
                std::shared_ptr<const HiddenVoxels> hidden) {
    const dicom::Series& series = parts.import.scan().series[std::size_t(index)];
    parts.window.message().clear();
    if (const QString notes = notesOn(parts.import.loadNotes(), table); !notes.isEmpty())
        showNotice(parts, notes);
    if (hidden)
        parts.window.message().offer(ui::MainWindow::tr("Show"));
    parts.window.setSubject(ui::windowSubject(series), ui::seriesNumber(series));
    parts.window.series().setCurrent(index);
    parts.window.setPatient(ui::patientLines(series));
    parts.window.setStartShown(false);
    showNoPicture(parts, ui::MainWindow::tr("Preparing %1...").arg(ui::seriesNumber(series)));
    parts.study.setVolume(volume);
    parts.document.open(std::move(volume), table, findings, std::move(hidden));
}

void showProgress(const DesktopParts& parts, double fraction, const QString& step) {
    parts.window.status().setProgress(fraction, step);
    parts.window.setStartShown(false);
    parts.window.viewport().setMessage(ui::sentence(step.toStdString()));
}

void showReadingEnded(const DesktopParts& parts) {
    parts.window.viewport().setMessage({});
    parts.window.setStartShown(!parts.document.hasVolume());
    parts.window.series().setCurrent(parts.window.series().current());
}

}  // namespace pdr::app
