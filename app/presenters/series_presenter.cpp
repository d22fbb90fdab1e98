#include "app/presenters/series_presenter.h"

#include <algorithm>

#include "app/scan/series_choice.h"
#include "render/slice/unit_window.h"
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

SeriesPresenter::SeriesPresenter(const Workspace& workspace) : Presenter(workspace), panel_(new ui::SeriesPanel) {
    window().addPanel(panel_, {"Series", ui::WindowDocks::tr("Series"), Qt::Key_F2, ui::PanelPlace::browser});
    connectWindow();
    connectImport();
    showRecentFolders();
}

void SeriesPresenter::connectWindow() {
    connect(&window(), &ui::MainWindow::folderChosen, this, &SeriesPresenter::open);
    connect(&window(), &ui::MainWindow::othersLeftOut, this, &SeriesPresenter::showOthersLeftOut);
    connect(&window(), &ui::MainWindow::cancelRequested, &import_, &ImportJob::cancel);
    connect(&window(), &ui::MainWindow::namesHiddenChanged, panel_, &ui::SeriesPanel::setNamesHidden);
    connect(panel_, &ui::SeriesPanel::seriesChosen, this, &SeriesPresenter::load);
    const ui::RecentMenu* recent = window().menuActions().recent;
    connect(recent, &ui::RecentMenu::rememberChosen, this, [this](bool remembered) {
        settings().keepRemembersFolders(remembered);
        showRecentFolders();
    });
    connect(recent, &ui::RecentMenu::forgetRequested, this, [this] {
        settings().forgetFolders();
        showRecentFolders();
    });
}

void SeriesPresenter::connectImport() {
    showProgressOf(import_);
    connect(&import_, &ImportJob::progressed, this, &SeriesPresenter::showProgress);
    connect(&import_, &ImportJob::cancelled, this, &SeriesPresenter::showEnd);
    connect(&import_, &ImportJob::failed, this, [this](const Error& error) {
        showEnd();
        showError(error);
    });
    connect(&import_, &ImportJob::scanned, this, &SeriesPresenter::showScan);
    connect(&import_, &ImportJob::arriving, this, &SeriesPresenter::showArriving);
    connect(&import_, &ImportJob::loaded, this, &SeriesPresenter::showVolume);
    connect(&images_, &SeriesImages::made, panel_, &ui::SeriesPanel::setImage);
}

void SeriesPresenter::open(const QString& folder) {
    if (window().confirmsLoss())
        import_.scanFolder(folder);
}

const dicom::Series* SeriesPresenter::series() const {
    return document().hasVolume() && shown_ >= 0 ? &import_.scan().series[std::size_t(shown_)] : nullptr;
}

void SeriesPresenter::close() {
    shown_ = -1;
    document().close();
    window().viewport().setMessage({});
    window().start().show();
    window().setChoosing(false);
    window().setSubject({});
    window().setPatient({});
    panel_->setNothingShown();
}

void SeriesPresenter::showScan(const dicom::ScanResult& scan, const QString& folder) {
    close();
    window().message().clear();
    window().setLastFolder(folder);
    panel_->setScan(scan);
    images_.make(scan, panel_->order());
    settings().keepFolder(folder);
    showRecentFolders();
    if (const int only = onlyLoadable(scan); only >= 0)
        return import_.loadSeries(only);
    showChoice(scan, folder);
}

/// Lets the user choose between several series, or says why none can be shown.
void SeriesPresenter::showChoice(const dicom::ScanResult& scan, const QString& folder) {
    window().setChoosing(true);
    window().start().hide();
    const QString choose = ui::MainWindow::tr("Choose a series from the list on the left.");
    if (firstLoadable(scan) >= 0)
        return window().viewport().setMessage(choose);
    Error error = nothingLoadable(scan).in(folder.toStdString());
    if (std::ranges::any_of(scan.series, [](const dicom::Series& series) { return series.series.resampled; })) {
        error.hint = phrase("The list offers a series of even slices, interpolated between those measured.");
        window().viewport().setMessage(choose);
        return showError(error);
    }
    panel_->setCurrent(scan.series.empty() ? -1 : panel_->order().front());
    error.hint = phrase("Open a folder with a CT series.");
    showError(error);
    window().viewport().setMessage(ui::MainWindow::tr("No series here can be shown. The list says why."));
}

void SeriesPresenter::showRecentFolders() {
    window().setRecentFolders(settings().recentFolders(), settings().remembersFolders());
}

void SeriesPresenter::load(int index) {
    if (!window().confirmsLoss())
        return panel_->setCurrent(panel_->current());
    close();
    import_.loadSeries(index);
}

/// Lets slices be looked at while the others are read, unless only the complete volume says which window suits it.
void SeriesPresenter::showArriving(std::shared_ptr<const ArrivingVolume> volume, int index) {
    const dicom::Series& series = import_.scan().series[std::size_t(index)];
    const std::optional<GreyWindow>& stated = series.window.window;
    if (!stated && !series.unit.isHu)
        return;
    showSubject(index);
    document().arrive(std::move(volume), stated ? inVoxels(*stated, series.unit) : GreyWindow());
}

void SeriesPresenter::showVolume(std::shared_ptr<const Volume> volume, int index, const segment::HiddenTable& table,
                                 const segment::Findings& findings, std::shared_ptr<const HiddenVoxels> hidden) {
    const dicom::Series& series = import_.scan().series[std::size_t(index)];
    ui::MessageBar& message = window().message();
    message.clear();
    if (const QString notes = notesOn(import_.loadNotes(), table); !notes.isEmpty())
        message.showNotice(notes);
    if (hidden)
        message.offer(ui::MainWindow::tr("Show"), [this] { document().setTable(Table::shown); });
    showSubject(index);
    shown_ = index;
    window().start().hide();
    window().viewport().setMessage(ui::MainWindow::tr("Preparing %1...").arg(ui::seriesNumber(series)));
    const GreyWindow seen = firstWindow(*volume, series.window.window);
    document().open(std::move(volume), table, findings, std::move(hidden), seen);
}

/// Says whose series it is of which slices or the image are shown.
void SeriesPresenter::showSubject(int index) {
    const dicom::Series& series = import_.scan().series[std::size_t(index)];
    panel_->setCurrent(index);
    window().setSubject(ui::windowSubject(series), ui::seriesNumber(series));
    window().setPatient(ui::patientLines(series), {panel_->numberedPatient()});
}

void SeriesPresenter::showProgress(double, const QString& step) {
    window().start().hide();
    window().viewport().setMessage(ui::sentence(step.toStdString()));
}

/// Shows that reading has ended without a volume. What was shown of it meanwhile goes.
void SeriesPresenter::showEnd() {
    if (document().arriving()) {
        close();
        window().status().showForAWhile(
            ui::MainWindow::tr("The series was not read to its end; its slices are shown no longer."));
    }
    window().viewport().setMessage({});
    window().start().setVisible(!document().hasVolume());
    panel_->setCurrent(panel_->current());
}

/// Says that other dropped folders are not opened, and repeats it below each message of the import, until the series is
/// loaded.
void SeriesPresenter::showOthersLeftOut() {
    auto* meanwhile = new QObject(this);
    const auto say = [this] {
        window().message().add(ui::MainWindow::tr("Only the first of the dropped folders is opened."));
    };
    connect(&import_, &ImportJob::scanned, meanwhile, say);
    connect(&import_, &ImportJob::loaded, meanwhile, say);
    connect(&import_, &ImportJob::failed, meanwhile, say);
    connect(&import_, &ImportJob::loaded, meanwhile, &QObject::deleteLater);
    connect(&import_, &ImportJob::failed, meanwhile, &QObject::deleteLater);
    connect(&import_, &ImportJob::cancelled, meanwhile, &QObject::deleteLater);
}

}  // namespace pdr::app
