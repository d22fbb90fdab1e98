#include "app/desktop/desktop.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QScreen>
#include <QStyle>
#include <utility>

#include "app/presenters/accuracy_presenter.h"
#include "app/presenters/camera_presenter.h"
#include "app/presenters/crosshair_presenter.h"
#include "app/presenters/ct_noise_presenter.h"
#include "app/presenters/cut_presenter.h"
#include "app/presenters/effects_presenter.h"
#include "app/presenters/help_presenter.h"
#include "app/presenters/image_presenter.h"
#include "app/presenters/light_presenter.h"
#include "app/presenters/looks_presenter.h"
#include "app/presenters/marks_presenter.h"
#include "app/presenters/nodes_presenter.h"
#include "app/presenters/parts_presenter.h"
#include "app/presenters/place_menu_presenter.h"
#include "app/presenters/plan_presenter.h"
#include "app/presenters/preferences_presenter.h"
#include "app/presenters/recovery_presenter.h"
#include "app/presenters/region_presenter.h"
#include "app/presenters/rendering_presenter.h"
#include "app/presenters/saving_presenter.h"
#include "app/presenters/series_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "app/presenters/start_presenter.h"
#include "app/presenters/tissue_presenter.h"
#include "app/presenters/view_presenter.h"
#include "app/presenters/visible_presenter.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

/// Returns the folder of the example scan, which `bootstrap run` writes beside the programs that it builds; empty if
/// there is none.
QString exampleFolder() {
    const QDir programs(QCoreApplication::applicationDirPath());
    for (const char* name : {"cranium", "phantom"})
        if (QString folder = QDir::cleanPath(programs.filePath(QString("../../example/") + name));
            QDir(folder).exists())
            return folder;
    return {};
}

/// Shrinks and moves `window` so that it fits its screen: saved geometry may be damaged, or from a larger screen.
void holdOnScreen(QWidget& window) {
    const QRect room = window.screen()->availableGeometry();
    const bool isLarge = window.isMaximized() || window.isFullScreen();
    const QRect kept = isLarge ? window.normalGeometry() : window.geometry();
    const QSize size = kept.size().boundedTo(room.size());
    if (size == kept.size() && room.intersects(kept))
        return;
    const Qt::WindowStates states = window.windowState();
    window.setWindowState(Qt::WindowNoState);
    window.setGeometry(QStyle::alignedRect(Qt::LeftToRight, Qt::AlignCenter, size, room));
    window.setWindowState(states);
}

/// Gives the window the place and the panels of the last run.
void place(ui::MainWindow& window, const Settings& settings) {
    window.resize(QSize(1480, 920).boundedTo(window.screen()->availableSize() * 0.95));
    window.restoreGeometry(settings.windowGeometry());
    window.restorePanels(settings.windowState());
    holdOnScreen(window);
}

}  // namespace

Desktop::Desktop(std::vector<NamedLook> looks, std::unique_ptr<Device> device, const QString& settingsFile, int threads,
                 std::filesystem::path powerSupplies)
    : settings_(settingsFile),
      document_(std::move(looks)),
      bridge_(std::move(device), threads),
      scenes_(std::make_unique<PlaceScenes>()) {
    addPresenters(settingsFile.isEmpty() ? QString() : QFileInfo(settingsFile).path(), std::move(powerSupplies));
    place(window_, settings_);
    connectPresenters();
    showDocument(Changes::all);
    presenter<SeriesPresenter>().close();
    window_.start().setExample(exampleFolder());
}

Desktop::~Desktop() {
    settings_.keepWindow(window_.saveGeometry(), window_.wantedState());
}

/// Adds the presenter of each feature. Their order is that of the panels in the View menu, and that in which they show
/// a frame; those that cancel a job on request are asked in it. `beside`: the folder of the user's looks and of plans
/// that were not saved; empty: where each usually is.
void Desktop::addPresenters(const QString& beside, std::filesystem::path powerSupplies) {
    auto& series = add<SeriesPresenter>();
    add<ImagePresenter>();
    add<ViewPresenter>();
    auto& looks = add<LooksPresenter>(beside.isEmpty() ? OwnLooks::usualFolder() : beside + "/looks");
    add<VisiblePresenter>(looks.visibleRow());
    add<CtNoisePresenter>(looks.panel());
    auto& tissue = add<TissuePresenter>();
    add<LightPresenter>();
    auto& camera = add<CameraPresenter>();
    add<CutPresenter>();
    add<RegionPresenter>();
    auto& slices = add<SlicesPresenter>();
    auto& crosshair = add<CrosshairPresenter>(slices, *scenes_);
    add<MarksPresenter>(slices, crosshair, *scenes_);
    add<PartsPresenter>(series, slices);
    add<PlaceMenuPresenter>(PlaceFeatures{crosshair, camera, tissue}, *scenes_);
    add<RenderingPresenter>();
    auto& accuracy = add<AccuracyPresenter>(std::move(powerSupplies));
    add<EffectsPresenter>();
    auto& nodes = add<NodesPresenter>();
    add<SavingPresenter>();
    auto& plans = add<PlanPresenter>();
    add<RecoveryPresenter>(plans, beside.isEmpty() ? RecoveryPresenter::usualFolder() : ui::fromQt(beside) / "plans");
    add<StartPresenter>(series, plans);
    add<HelpPresenter>();
    add<PreferencesPresenter>();
    window_.fillToolBar();
    QObject::connect(&nodes, &NodesPresenter::eventsChanged, &accuracy, &AccuracyPresenter::setEvents);
}

template <class One, class... Arguments>
One& Desktop::add(Arguments&&... arguments) {
    auto one = std::make_unique<One>(workspace(), std::forward<Arguments>(arguments)...);
    One& added = *one;
    presenters_.push_back(std::move(one));
    return added;
}

void Desktop::connectPresenters() {
    QObject::connect(&document_, &Document::sceneChanged, &bridge_, &RenderBridge::submit);
    QObject::connect(&document_, &Document::displayChanged, &bridge_, &RenderBridge::setDisplay);
    QObject::connect(&document_, &Document::closing, &bridge_, [this] {
        for (const auto& presenter : presenters_)
            presenter->releaseVolume();
        bridge_.clear();
    });
    QObject::connect(&document_, &Document::changed, &window_, [this](Changes changes) { showDocument(changes); });
    QObject::connect(&bridge_, &RenderBridge::frameReady, &window_,
                     [this](const std::shared_ptr<const Frame>& frame) { showFrame(frame); });
    QObject::connect(&window_.status(), &ui::StatusLine::cancelRequested, &window_, [this] { cancelJob(); });
}

void Desktop::open(const QString& path) {
    presenter<SeriesPresenter>().open(ui::folderOf(QFileInfo(path)));
}

void Desktop::showDocument(Changes changes) {
    for (const auto& presenter : presenters_) {
        if (has(changes, Changes::series))
            presenter->clearImage();
        presenter->showDocument(changes);
    }
}

void Desktop::showFrame(const std::shared_ptr<const Frame>& frame) {
    if (frame->error.empty()) {
        for (const auto& presenter : presenters_)
            presenter->showFrame(frame);
        return;
    }
    for (const auto& presenter : presenters_)
        presenter->clearImage();
    window_.viewport().setMessage(ui::MainWindow::tr("No image"));
    window_.message().showError({frame->error, "", ""});
}

/// Cancels one running job.
void Desktop::cancelJob() {
    for (const auto& presenter : presenters_)
        if (presenter->cancelJob())
            return;
}

}  // namespace pdr::app
