#include "app/presenters/parts_presenter.h"

#include <functional>

#include "app/presenters/look_text.h"
#include "app/presenters/part_rows.h"
#include "app/presenters/series_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "ui/text/room_text.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/screen_colour.h"

namespace pdr::app {

PartsPresenter::PartsPresenter(const Workspace& workspace, const SeriesPresenter& series, SlicesPresenter& slices)
    : Presenter(workspace), series_(series), slices_(slices), panel_(new ui::PartsPanel), edits_(document()) {
    window().addPanel(panel_, {"Parts", ui::WindowDocks::tr("Parts"), QKeySequence(Qt::CTRL | Qt::Key_P)});
    connectPanel();
    connectStyles();
    connectJob();
}

void PartsPresenter::connectPanel() {
    connect(panel_, &ui::PartsPanel::labelFileWanted, this, &PartsPresenter::askForLabels);
    connect(panel_, &ui::PartsPanel::labelFolderWanted, this, [this] {
        if (const QString folder = ui::askForMasks(&window()); !folder.isEmpty())
            open(folder);
    });
    connect(panel_, &ui::PartsPanel::vesselsWanted, this, [this] { find(PartRule::vessels); });
    connect(panel_, &ui::PartsPanel::shellsWanted, this, [this] { find(PartRule::shells); });
    connect(panel_, &ui::PartsPanel::mirrorWanted, this, [this] { find(PartRule::mirror); });
    connect(panel_, &ui::PartsPanel::implantsWanted, this, [this] { find(PartRule::metal); });
    connect(panel_, &ui::PartsPanel::removeWanted, &edits_, [this] { edits_.setParts({}, nullptr); });
    connect(panel_, &ui::PartsPanel::tintChosen, this, &PartsPresenter::showTint);
}

void PartsPresenter::connectStyles() {
    connect(panel_, &ui::PartsPanel::stateChosen, &edits_, &PartEdits::setState);
    connect(panel_, &ui::PartsPanel::colourChosen, &edits_,
            [this](const std::vector<int>& parts, const QColor& colour) {
                edits_.setColour(parts, ui::linearColour(colour));
            });
    connect(panel_, &ui::PartsPanel::lookChosen, &edits_, [this](const std::vector<int>& parts, int look) {
        edits_.setLook(parts, look < 0 ? -1 : looks_[std::size_t(look)]);
    });
}

void PartsPresenter::connectJob() {
    showProgressOf(job_);
    connect(&document(), &Document::partsWanted, this,
            [this](const PartSources& sources) { afterImage_.call([this, sources] { make(sources); }); });
    connect(&window(), &ui::MainWindow::cancelRequested, &job_, &PartsJob::cancel);
    connect(&job_, &PartsJob::added, &edits_, &PartEdits::setParts);
    connect(&job_, &PartsJob::added, this, &PartsPresenter::offerMissing);
    connect(&job_, &PartsJob::made, &document(), &Document::takeParts);
    connect(&job_, &PartsJob::resamplingWanted, this, &PartsPresenter::offerResampling);
    connect(&job_, &PartsJob::labelsMissing, this, &PartsPresenter::sayLabelsMissing);
    connect(&job_, &PartsJob::cancelled, &edits_, &PartEdits::keepParts);
    connect(&job_, &PartsJob::failed, this, [this](const Error& error) {
        edits_.keepParts();
        showError(error);
    });
    connect(&job_, &PartsJob::progressed, panel_, [this] { panel_->setBusy(true); });
    connect(&job_, &PartsJob::finished, panel_, [this] { panel_->setBusy(false); });
}

PartsJob::Scan PartsPresenter::scan() const {
    const dicom::Series* series = series_.series();
    return {document().scan(), series ? std::optional(*series) : std::nullopt};
}

void PartsPresenter::askForLabels() {
    if (const QString file = ui::askForLabels(&window()); !file.isEmpty())
        open(file);
}

void PartsPresenter::open(const QString& path, Resampling resampling) {
    if (document().hasVolume())
        job_.open(scan(), path, resampling, document().plan().partSources);
}

void PartsPresenter::find(PartRule rule) {
    if (document().hasVolume())
        job_.find(scan(), rule, document().plan().partSources);
}

/// Makes the parts that the plan wants, unless it has come to want others.
void PartsPresenter::make(const PartSources& sources) {
    if (document().hasVolume() && document().plan().partSources == sources)
        job_.make(scan(), sources);
}

/// Says which grid the label map has and which the scan, and offers to resample the one to the other.
void PartsPresenter::offerResampling(const QString& file, const Error& error) {
    window().message().showError(error);
    window().message().offer(ui::MainWindow::tr("Resample"), [this, file] { open(file, Resampling::nearest); });
}

void PartsPresenter::sayLabelsMissing() {
    edits_.dropLabels();
    window().message().showNotice(ui::MainWindow::tr(
        "This plan shows parts of a label map, of which it holds neither the voxels nor the place. Open that label map "
        "again, and its parts look as they did."));
    window().message().offer(ui::MainWindow::tr("Open label map..."), [this] { askForLabels(); });
}

/// Says which parts the look that was chosen shows and the scan lacks, and offers to find them.
void PartsPresenter::offerMissing() {
    const auto offer = [this](const QString& what, const QString& action, const std::function<void()>& remedy) {
        window().message().showNotice(what);
        window().message().offer(action, remedy);
    };
    switch (missingParts(document())) {
        case MissingParts::none:
            return;
        case MissingParts::vessels:
            return offer(ui::MainWindow::tr("This look shows vessels, which have not been found in this scan yet."),
                         ui::MainWindow::tr("Find vessels"), [this] { find(PartRule::vessels); });
        case MissingParts::shells:
            return offer(
                ui::MainWindow::tr("This look shows skin or muscle, which has not been found in this scan yet."),
                ui::MainWindow::tr("Find skin and muscle"), [this] { find(PartRule::shells); });
        case MissingParts::mirror:
            return offer(ui::MainWindow::tr("This look shows bone that one side has and the other lacks, which has not "
                                            "been looked for in this scan yet."),
                         ui::MainWindow::tr("Find mirrored bone"), [this] { find(PartRule::mirror); });
        case MissingParts::metal:
            return offer(ui::MainWindow::tr("This look shows implants, which have not been found in this scan yet."),
                         ui::MainWindow::tr("Find implants"), [this] { find(PartRule::metal); });
        case MissingParts::labels:
            return offer(ui::MainWindow::tr("This look shows parts of a label map, and none with them is open."),
                         ui::MainWindow::tr("Open label map..."), [this] { askForLabels(); });
    }
}

void PartsPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series))
        panel_->setEnabled(document().hasVolume());
    if (has(changes, Changes::looks | Changes::series))
        showLooks();
    if (!has(changes, Changes::series | Changes::looks | Changes::mask | Changes::partSources | Changes::partStyles |
                          Changes::model))
        return;
    if (has(changes, Changes::lookName))
        offerMissing();
    panel_->setRows(partRows(document()));
    panel_->setNotes(partNotes(document()));
    showTint();
}

/// Offers the looks that have a curve for images with parts.
void PartsPresenter::showLooks() {
    QStringList names;
    looks_.clear();
    for (int i = 0; document().looks().holds(i); ++i)
        if (showsParts(document().looks()[i].model)) {
            looks_.push_back(i);
            names << nameText(document().looks()[i]);
        }
    panel_->setLooks(names);
}

void PartsPresenter::showTint() {
    slices_.setTint(panel_->tints() ? partTint(document()) : SliceTint{});
}

void PartsPresenter::showFrame(const std::shared_ptr<const Frame>&) {
    afterImage_.imageStands();
}

void PartsPresenter::releaseVolume() {
    afterImage_.reset();
    job_.forget();
}

}  // namespace pdr::app
