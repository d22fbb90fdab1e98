#include "app/desktop/wiring.h"

#include "app/desktop/copied_picture.h"
#include "app/desktop/keep_looks.h"
#include "app/desktop/requests.h"
#include "app/desktop/show_document.h"
#include "app/desktop/show_frame.h"
#include "app/desktop/show_looks.h"
#include "app/desktop/show_message.h"
#include "app/desktop/show_nodes.h"
#include "app/desktop/show_scan.h"

namespace pdr::app {
namespace {

/// 1. The user chooses files, which become a volume.
void wireImport(const DesktopParts& parts) {
    ImportJob& import = parts.import;
    ui::MainWindow& window = parts.window;
    QObject::connect(&window, &ui::MainWindow::folderChosen, &import, &ImportJob::scanFolder);
    QObject::connect(&window, &ui::MainWindow::othersLeftOut, &window, [parts] { showOthersLeftOut(parts); });
    QObject::connect(&window.series(), &ui::SeriesPanel::seriesChosen, &window,
                     [parts](int index) { showReading(parts, index); });
    QObject::connect(&window, &ui::MainWindow::cancelRequested, &import, &ImportJob::cancel);
    QObject::connect(&parts.document, &Document::closing, &window, [parts] { letGoOfVolume(parts); });

    QObject::connect(&window.status(), &ui::StatusLine::cancelRequested, &window, [parts] { cancelWhatRuns(parts); });

    QObject::connect(&parts.seriesPictures, &SeriesPictures::made, &window.series(), &ui::SeriesPanel::setPicture);
    QObject::connect(&import, &ImportJob::progressed, &window,
                     [parts](double fraction, const QString& step) { showProgress(parts, fraction, step); });
    QObject::connect(&import, &ImportJob::finished, &window.status(), &ui::StatusLine::endProgress);
    QObject::connect(&import, &ImportJob::cancelled, &window, [parts] { showReadingEnded(parts); });
    QObject::connect(&import, &ImportJob::failed, &window, [parts] { showReadingEnded(parts); });
    QObject::connect(&import, &ImportJob::failed, &window, [parts](const Error& error) { showFailure(parts, error); });
    QObject::connect(&import, &ImportJob::scanned, &window,
                     [parts](const dicom::ScanResult& scan, const QString& folder) { showScan(parts, scan, folder); });
    QObject::connect(&import, &ImportJob::loaded, &window,
                     [parts](std::shared_ptr<const Volume> volume, int index, const segment::HiddenTable& table,
                             const segment::Findings& findings, std::shared_ptr<const HiddenVoxels> hidden) {
                         showVolume(parts, std::move(volume), index, table, findings, std::move(hidden));
                     });
}

/// 2. The user edits the document.
void wireEdits(const DesktopParts& parts) {
    Document& document = parts.document;
    ui::MainWindow& window = parts.window;
    // View and film
    QObject::connect(&window.viewport(), &ui::Viewport::cameraEdited, &document, &Document::setCamera);
    QObject::connect(&window.viewport(), &ui::Viewport::sizeInPixelsChanged, &window,
                     [parts] { keepOrFitFilm(parts); });
    QObject::connect(&window, &ui::MainWindow::fitRequested, &window, [parts] { fitFilm(parts); });
    QObject::connect(&window, &ui::MainWindow::viewChosen, &document, &Document::setView);
    QObject::connect(&window, &ui::MainWindow::resetRequested, &document, &Document::resetView);
    // Table, look, visible parts and rendering
    QObject::connect(&window, &ui::MainWindow::tableChosen, &document,
                     [&document](bool shown) { document.setTable(shown ? Table::shown : Table::hidden); });
    QObject::connect(&window.message(), &ui::MessageBar::offerTaken, &document,
                     [&document] { document.setTable(Table::shown); });
    QObject::connect(&window.look(), &ui::LookPanel::lookChosen, &document, &Document::chooseLook);
    QObject::connect(&window.look(), &ui::LookPanel::brightnessChosen, &document, &Document::setBrightness);
    QObject::connect(&window.visible(), &ui::VisibleRow::chosen, &document,
                     [&document](const Visible& visible) { document.setVisible(visible); });
    QObject::connect(&window, &ui::MainWindow::smoothingChosen, &document, &Document::setSmoothed);
    QObject::connect(&window.rendering(), &ui::RenderPanel::estimatorChosen, &document, &Document::setEstimator);
    QObject::connect(&window.rendering(), &ui::RenderPanel::scheduleChosen, &document, &Document::setSchedule);
    QObject::connect(&window.effects(), &ui::EffectLedger::leaveOutChosen, &document,
                     [parts] { leaveOutUnseen(parts); });
    // Tissue, light and camera
    QObject::connect(&window.tissue(), &ui::TissuePanel::transferFunctionEdited, &parts.tissue,
                     &TissueEdits::setTransferFunction);
    QObject::connect(&window.viewport(), &ui::Viewport::tissueDragged, &parts.tissue, &TissueEdits::drag);
    QObject::connect(&window.viewport(), &ui::Viewport::tissuePicked, &window,
                     [parts](QPointF place) { pickTissue(parts, place); });
    QObject::connect(&parts.study, &TissueStudy::tissueFound, &parts.tissue, &TissueEdits::addBell);
    QObject::connect(&window.light(), &ui::LightPanel::lightingEdited, &parts.light, &LightEdits::setLighting);
    QObject::connect(&window.viewport(), &ui::Viewport::lightDragged, &parts.light, &LightEdits::turn);
    QObject::connect(&window.camera(), &ui::CameraPanel::cameraEdited, &document,
                     [&document](const Camera& camera) { document.setCamera(camera, false); });
    QObject::connect(&window.camera(), &ui::CameraPanel::backgroundChosen, &window,
                     [parts](const std::optional<QColor>& colour) { setBackground(parts, colour); });
    // Optical model and focus
    QObject::connect(&window.light().model(), &ui::ModelChoice::modelChosen, &window,
                     [parts](Model model) { chooseModel(parts, model); });
    QObject::connect(&parts.modelTrial, &ModelTrial::measured, &window,
                     [parts](Model model, Model before, double timeFactor, double levels) {
                         if (model == parts.document.setup().model)
                             parts.window.light().model().setCost(ui::ModelCost{before, timeFactor, levels});
                     });
    QObject::connect(&window.viewport(), &ui::Viewport::focusPicked, &window,
                     [parts](QPointF place) { pickFocus(parts, place); });
    QObject::connect(&parts.study, &TissueStudy::depthFound, &document,
                     [&document](double depthMm) { document.setFocus(depthMm); });
    // History
    QObject::connect(&window, &ui::MainWindow::undoRequested, &document, &Document::undo);
    QObject::connect(&window, &ui::MainWindow::redoRequested, &document, &Document::redo);
}

/// Connects the cutting tools to the document.
void wireCuts(const DesktopParts& parts) {
    Document& document = parts.document;
    ui::CutTools& cut = parts.window.cut();
    QObject::connect(&cut.layer(), &ui::CutLayer::clipEdited, &document, &Document::setClip);
    QObject::connect(&cut.layer(), &ui::CutLayer::gestureGivenUp, &document, &Document::giveUpGesture);
    QObject::connect(&cut.panel(), &ui::CutPanel::clipChosen, &document,
                     [&document](const Clip& clip) { document.setClip(clip); });
    QObject::connect(&cut, &ui::CutTools::planeWanted, &parts.cut, &CutEdits::addPlane);
    QObject::connect(&cut.pen(), &ui::FreehandPen::drawn, &parts.cut, &CutEdits::addFreehand);
    QObject::connect(&cut, &ui::CutTools::uncutWanted, &parts.cut, &CutEdits::undoAll);
}

/// Connects the document's requests for masks to the job that makes them in the background.
void wireMasks(const DesktopParts& parts) {
    MaskJob& masks = parts.masks;
    ui::StatusLine& status = parts.window.status();
    QObject::connect(&parts.document, &Document::maskWanted, &masks, &MaskJob::make);
    QObject::connect(&masks, &MaskJob::progressed, &status, &ui::StatusLine::setProgress);
    QObject::connect(&masks, &MaskJob::finished, &status, &ui::StatusLine::endProgress);
    QObject::connect(&masks, &MaskJob::made, &parts.document, &Document::setMask);
    QObject::connect(&masks, &MaskJob::refused, &parts.window, [parts](const Visible& visible, const Error& error) {
        parts.document.setMask(visible, nullptr);
        showFailure(parts, error);
    });
    QObject::connect(&masks, &MaskJob::failed, &parts.window, [parts](const Error& error) {
        parts.document.keepVisible();
        showFailure(parts, error);
    });
    QObject::connect(&masks, &MaskJob::cancelled, &parts.document, &Document::keepVisible);
}

/// Connects the choice of an environment image to the job that reads it and to the light.
void wireSky(const DesktopParts& parts) {
    SkyJob& sky = parts.sky;
    ui::MainWindow& window = parts.window;
    ui::StatusLine& status = window.status();
    QObject::connect(&window, &ui::MainWindow::skyDropped, &sky, &SkyJob::read);
    QObject::connect(&window.light(), &ui::LightPanel::skyChosen, &sky, &SkyJob::read);
    QObject::connect(&sky, &SkyJob::progressed, &status, &ui::StatusLine::setProgress);
    QObject::connect(&sky, &SkyJob::finished, &status, &ui::StatusLine::endProgress);
    QObject::connect(&sky, &SkyJob::failed, &window, [parts](const Error& error) { showFailure(parts, error); });
    QObject::connect(&sky, &SkyJob::found, &parts.light, &LightEdits::setSky);
}

/// 3. The document's scene goes to the renderer.
void wireRendering(const DesktopParts& parts) {
    Document& document = parts.document;
    RenderBridge& bridge = parts.bridge;
    ui::MainWindow& window = parts.window;
    QObject::connect(&document, &Document::displayChanged, &bridge, &RenderBridge::setDisplay);
    QObject::connect(&document, &Document::sceneChanged, &bridge, &RenderBridge::submit);
    const ui::RenderPanel& rendering = window.rendering();
    QObject::connect(&rendering, &ui::RenderPanel::paceChosen, &bridge, &RenderBridge::setPace);
    QObject::connect(&rendering, &ui::RenderPanel::deviceChosen, &bridge, &RenderBridge::setDevice);
    QObject::connect(&window.foot().strip(), &ui::AccuracyStrip::targetChosen, &bridge, &RenderBridge::setTarget);
    QObject::connect(&window.accuracy().stop(), &ui::StopRow::ruleChosen, &bridge, &RenderBridge::setStop);
    QObject::connect(&window, &ui::MainWindow::errorMapChosen, &bridge, &RenderBridge::setErrorMap);
    QObject::connect(&window, &ui::MainWindow::regionChosen, &bridge, &RenderBridge::setRegion);
    QObject::connect(&window, &ui::MainWindow::pauseChosen, &bridge, &RenderBridge::setPaused);
    QObject::connect(&window, &ui::MainWindow::captionChosen, &bridge, &RenderBridge::setCaptioned);
    QObject::connect(&window, &ui::MainWindow::unseenChanged, &bridge, &RenderBridge::setUnseen);
    QObject::connect(&window, &ui::MainWindow::effectsShown, &bridge, &RenderBridge::watchEffects);
    QObject::connect(&window, &ui::MainWindow::saveRequested, &bridge,
                     [parts](const QString& file, ui::Annotate annotate) { savePicture(parts, file, annotate); });
    QObject::connect(&window, &ui::MainWindow::copyRequested, &window, [parts] { copyPicture(parts); });
}

/// 4. Frames and the document's state go to the screen.
void wireScreen(const DesktopParts& parts) {
    ui::MainWindow& window = parts.window;
    QObject::connect(&parts.bridge, &RenderBridge::frameReady, &window,
                     [parts](const std::shared_ptr<const Frame>& frame) { showFrame(parts, frame); });
    QObject::connect(&parts.bridge, &RenderBridge::ledgerChanged, &window, [parts] { showEffects(parts); });
    QObject::connect(&parts.bridge, &RenderBridge::pausedChanged, &window, &ui::MainWindow::setPaused);
    QObject::connect(&parts.bridge, &RenderBridge::pausedChanged, &window, [parts] { showStatus(parts); });
    QObject::connect(&window.viewport(), &ui::Viewport::rested, &parts.bridge, &RenderBridge::askErrorAt);
    QObject::connect(&parts.bridge, &RenderBridge::errorFound, &window,
                     [parts](QPointF place, const LevelErrorsAt& errors) { showErrorAt(parts, place, errors); });
    QObject::connect(&parts.bridge, &RenderBridge::stopChanged, &window,
                     [parts](const StopRule& rule) { showStop(parts, rule); });
    QObject::connect(&parts.bridge, &RenderBridge::deviceChanged, &window.rendering(), &ui::RenderPanel::setDevice);
    QObject::connect(&parts.bridge, &RenderBridge::noticed, &window,
                     [parts](const QString& sentences) { showNotice(parts, sentences); });
    QObject::connect(&parts.battery, &BatteryRest::restsChanged, &window, [parts] { showStatus(parts); });
    QObject::connect(&parts.study, &TissueStudy::histogramFound, &window.tissue(), &ui::TissuePanel::setHistogram);
    QObject::connect(&parts.study, &TissueStudy::nothingFound, &window,
                     [parts] { parts.window.status().showForAWhile(ui::MainWindow::tr("No tissue at this point")); });
    QObject::connect(&parts.bridge, &RenderBridge::saved, &window,
                     [parts](const QString& file) { showSaved(parts, file); });
    QObject::connect(&parts.bridge, &RenderBridge::saveFailed, &window,
                     [parts](const Error& error) { showFailure(parts, error); });
    QObject::connect(&parts.document, &Document::looksChanged, &window, [parts] { showLooks(parts); });
    QObject::connect(&parts.document, &Document::sceneChanged, &window, [parts] { showDocument(parts); });
    QObject::connect(&parts.document, &Document::displayChanged, &window, [parts] { showDocument(parts); });
}

/// Connects the panel of render nodes to the nodes.
void wireNodes(const DesktopParts& parts) {
    NodesJob& nodes = parts.nodes;
    ui::NodesPanel& panel = parts.window.nodes();
    QObject::connect(&panel, &ui::NodesPanel::bundleRequested, &nodes, &NodesJob::setBundle);
    QObject::connect(&panel, &ui::NodesPanel::listenRequested, &nodes, &NodesJob::listen);
    QObject::connect(&panel, &ui::NodesPanel::addRequested, &nodes, &NodesJob::add);
    QObject::connect(&panel, &ui::NodesPanel::pauseRequested, &nodes, &NodesJob::setPaused);
    QObject::connect(&panel, &ui::NodesPanel::removeRequested, &nodes, &NodesJob::remove);
    QObject::connect(&panel, &ui::NodesPanel::splitRequested, &nodes, &NodesJob::setSplit);
    QObject::connect(&nodes, &NodesJob::failed, &panel, &ui::NodesPanel::setProblem);
    QObject::connect(&nodes, &NodesJob::changed, &panel, [parts] { showNodes(parts); });
    QObject::connect(&nodes, &NodesJob::wantedChanged, &panel, [parts] {
        showWantedNodes(parts);
        keepNodes(parts);
    });
}

/// 5. Small images of the looks follow the view and are shown in the gallery.
void wireLooks(const DesktopParts& parts) {
    QObject::connect(&parts.document, &Document::sceneChanged, &parts.looks,
                     [parts](const Scene&, bool moving) { orderLookPictures(parts, moving); });
    QObject::connect(
        &parts.looks, &LookPictures::made, &parts.window,
        [parts](int look, const QImage& picture, double stops) { showLookPicture(parts, look, picture, stops); });
    const ui::LookMenu& menu = parts.window.look().menu();
    QObject::connect(&menu, &ui::LookMenu::saveWanted, &parts.window,
                     [parts](const QString& name) { saveLook(parts, name); });
    QObject::connect(&menu, &ui::LookMenu::renameWanted, &parts.window,
                     [parts](const QString& from, const QString& to) { renameLook(parts, from, to); });
    QObject::connect(&menu, &ui::LookMenu::deleteWanted, &parts.window,
                     [parts](const QString& name) { deleteLook(parts, name); });
    QObject::connect(&menu, &ui::LookMenu::importWanted, &parts.window,
                     [parts](const QString& file) { importLook(parts, file); });
    QObject::connect(&menu, &ui::LookMenu::exportWanted, &parts.window,
                     [parts](const QString& file) { exportLook(parts, file); });
}

/// 6. An image that is rendered in parallel with the session goes to a file.
void wirePicture(const DesktopParts& parts) {
    PictureJob& picture = parts.picture;
    ui::MainWindow& window = parts.window;
    ui::StatusLine& status = window.status();
    QObject::connect(&window, &ui::MainWindow::pictureOrdered, &window,
                     [parts](const ui::PictureOrder& order) { makePicture(parts, order); });
    QObject::connect(&picture, &PictureJob::progressed, &status, &ui::StatusLine::setProgress);
    QObject::connect(&picture, &PictureJob::finished, &status, &ui::StatusLine::endProgress);
    QObject::connect(&picture, &PictureJob::progressed, &window, [&window] {
        window.setQuestionOnClosing(ui::MainWindow::tr("An image is still rendering. Quit and discard it?"));
    });
    QObject::connect(&picture, &PictureJob::finished, &window, [&window] { window.setQuestionOnClosing({}); });
    QObject::connect(&picture, &PictureJob::saved, &window, [parts](const QString& file) { showSaved(parts, file); });
    QObject::connect(&picture, &PictureJob::cancelled, &status,
                     [&status] { status.showForAWhile(ui::MainWindow::tr("Cancelled: no image was saved")); });
    QObject::connect(&picture, &PictureJob::failed, &window,
                     [parts](const Error& error) { showFailure(parts, error); });
}

/// 7. Choices for this machine are saved.
void wireSettings(const DesktopParts& parts) {
    QObject::connect(&parts.window, &ui::MainWindow::rememberFoldersChosen, &parts.window, [parts](bool remembered) {
        parts.settings.keepRemembersFolders(remembered);
        showRecentFolders(parts);
    });
    QObject::connect(&parts.window, &ui::MainWindow::forgetFoldersRequested, &parts.window, [parts] {
        parts.settings.forgetFolders();
        showRecentFolders(parts);
    });
    QObject::connect(&parts.window, &ui::MainWindow::keysChosen, &parts.window,
                     [parts](const QMap<QString, QString>& keys) { parts.settings.keepKeys(keys); });
    QObject::connect(&parts.window, &ui::MainWindow::languageChosen, &parts.window, [parts](const QString& code) {
        parts.settings.keepLanguage(code);
        parts.window.status().showForAWhile(ui::MainWindow::tr("The language changes after a restart"));
    });
    QObject::connect(&parts.window, &ui::MainWindow::themeChosen, &parts.window, [parts](ui::ThemeChoice choice) {
        parts.settings.keepTheme(choice);
        ui::applyTheme(*qApp, choice);
    });
    const ui::RenderPanel& rendering = parts.window.rendering();
    QObject::connect(&rendering, &ui::RenderPanel::deviceChosen, &parts.window,
                     [parts](const QString& name) { parts.settings.keepDevice(name); });
    QObject::connect(&rendering, &ui::RenderPanel::paceChosen, &parts.window,
                     [parts](const FrameBudget& pace) { parts.settings.keepPace(pace); });
    QObject::connect(&parts.window, &ui::MainWindow::captionChosen, &parts.window,
                     [parts](bool captioned) { parts.settings.keepCaptioned(captioned); });
    QObject::connect(&parts.window.foot().strip(), &ui::AccuracyStrip::targetChosen, &parts.window,
                     [parts](double levels) { parts.settings.keepTarget(levels); });
    QObject::connect(&parts.window.accuracy().stop(), &ui::StopRow::ruleChosen, &parts.window,
                     [parts](const StopRule& rule) { parts.settings.keepTarget(rule.levels); });
}

}  // namespace

void wire(const DesktopParts& parts) {
    wireImport(parts);
    wireEdits(parts);
    wireCuts(parts);
    wireMasks(parts);
    wireSky(parts);
    wireRendering(parts);
    wireScreen(parts);
    wireNodes(parts);
    wireLooks(parts);
    wirePicture(parts);
    wireSettings(parts);
}

}  // namespace pdr::app
