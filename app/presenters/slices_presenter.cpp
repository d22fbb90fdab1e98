#include "app/presenters/slices_presenter.h"

#include <QActionGroup>
#include <QClipboard>
#include <QCursor>
#include <QGuiApplication>
#include <QMenu>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "app/presenters/place_text.h"
#include "app/presenters/slice_framing.h"
#include "app/presenters/window_menu.h"
#include "render/slice/unit_window.h"
#include "render/slice/window_presets.h"
#include "ui/text/language.h"
#include "ui/text/value_text.h"

namespace pdr::app {
namespace {

/// What moves is at rest after this time without a move, and is then shown in full.
constexpr auto kAtRest = std::chrono::milliseconds(150);

/// Slices of more pixels are coarse while they move: in full they would take longer than a frame.
constexpr int kMostMovingPixels = 1024 * 768;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Slices)
};

QString nameOf(AnatomicalPlane plane, int index, int count) {
    switch (plane) {
        case AnatomicalPlane::axial:
            return Texts::tr("Axial %1 of %2").arg(index).arg(count);
        case AnatomicalPlane::coronal:
            return Texts::tr("Coronal %1 of %2").arg(index).arg(count);
        case AnatomicalPlane::sagittal:
            break;
    }
    return Texts::tr("Sagittal %1 of %2").arg(index).arg(count);
}

/// Returns the preset of the digit `key` that follows `window`; none: no preset has that key.
std::optional<GreyWindow> presetAfter(char key, const GreyWindow& window) {
    std::vector<GreyWindow> presets;
    for (const WindowPreset& preset : windowPresets())
        if (preset.key == key)
            presets.push_back(preset.window);
    if (presets.empty())
        return std::nullopt;
    const auto current = std::ranges::find(presets, window);
    return current == presets.end() || current + 1 == presets.end() ? presets.front() : current[1];
}

}  // namespace

SlicesPresenter::SlicesPresenter(const Workspace& workspace) : Presenter(workspace) {
    for (const AnatomicalPlane plane : kAnatomicalPlanes) {
        Slice& slice = slices_[std::size_t(plane)];
        slice.view = new ui::SliceView(plane);
        window().addSlice(slice.view, slice.view->tools());
        connectSlice(slice);
    }
    atRest_.setSingleShot(true);
    atRest_.setInterval(kAtRest);
    connect(&atRest_, &QTimer::timeout, this, [this] { requestAll(false); });
    arrival_.emplace(this->workspace(), view(AnatomicalPlane::axial));
    connect(&*arrival_, &ArrivalWatch::more, this, &SlicesPresenter::showArrived);
    window().addMenu(ui::MainWindow::tr("Slices"), [this](QMenu& menu) { fillMenu(menu); });
}

void SlicesPresenter::fillMenu(QMenu& menu) {
    menu_ = &menu;
    auto* one = new QActionGroup(this);
    const std::array<QString, 3> names{Texts::tr("&Image alone"), Texts::tr("Slices &beside the image"),
                                       Texts::tr("Four &views")};
    for (const ViewLayout layout : kViewLayouts) {
        QAction* action = layouts_[std::size_t(layout)] = one->addAction(menu.addAction(names[std::size_t(layout)]));
        action->setCheckable(true);
        action->setChecked(layout == window().views().layout());
        connect(action, &QAction::triggered, this, [this, layout] { setLayout(layout); });
    }
    addWindowMenu(menu);
    QAction* next = menu.addAction(Texts::tr("&Next layout"), QKeySequence(Qt::Key_L));
    next->setObjectName("nextLayout");
    next->setToolTip(Texts::tr("Shows the image alone, with slices beside it, or as one of four views."));
    connect(next, &QAction::triggered, this,
            [this] { setLayout(ViewLayout((int(window().views().layout()) + 1) % int(std::size(kViewLayouts)))); });
}

/// Adds the windows, which one key offers where the pointer is.
void SlicesPresenter::addWindowMenu(QMenu& menu) {
    windows_ = new QMenu(Texts::tr("&Window of the slices"), &menu);
    fillWindowMenu(
        *windows_, [this](const GreyWindow& window) { setWindow(window); }, [this](char key) { chooseWindow(key); });
    offerWindows_ = menu.addAction(Texts::tr("&Window..."), QKeySequence(Qt::Key_W));
    offerWindows_->setObjectName("greyWindow");
    offerWindows_->setToolTip(Texts::tr("Offers the windows in which slices are shown: bone, lung, brain and others."));
    connect(offerWindows_, &QAction::triggered, this, [this] { windows_->popup(QCursor::pos()); });
}

/// Sets the window, and shows the slices that are seen through it.
void SlicesPresenter::setWindow(const GreyWindow& shown) {
    Navigation navigation = document().plan().navigation;
    navigation.window = shown;
    document().navigate(navigation);
    showSlices();
}

void SlicesPresenter::connectSlice(Slice& slice) {
    ui::SliceView* view = slice.view;
    connect(&slice.job, &SliceJob::made, this,
            [this, &slice](const QImage& grey, const SlicePlane& plane, const GreyWindow& window) {
                show(slice, grey, plane, window);
            });
    connect(view, &ui::SliceView::resized, this, [this, &slice] { request(slice); });
    connect(view, &ui::SliceView::pointed, &document(), &Document::moveCrosshair);
    connect(view, &ui::SliceView::stepped, this, [this, &slice](int count) {
        if (slice.stack)
            document().moveCrosshair(stepped(*slice.stack, document().plan().navigation.crosshairMm, count));
    });
    connect(view, &ui::SliceView::nudged, this, [this, &slice](QPoint voxels) {
        if (slice.stack)
            document().moveCrosshair(nudged(*slice.stack, scan_.geometry(), document().plan().navigation.crosshairMm,
                                            {voxels.x(), voxels.y()}));
    });
    connect(view, &ui::SliceView::panned, this, [this, &slice](dvec2 mm) {
        Navigation navigation = document().plan().navigation;
        framingOf(navigation, slice).panMm -= mm;
        document().navigate(navigation);
    });
    connect(view, &ui::SliceView::zoomed, this, [this, &slice](double factor, dvec3 placeMm) {
        Navigation navigation = document().plan().navigation;
        SliceFraming& framing = framingOf(navigation, slice);
        if (slice.stack)
            framing = zoomed(framing, slice.stack->slice(0), factor, placeMm);
        document().navigate(navigation);
    });
    connect(view, &ui::SliceView::windowChosen, this, &SlicesPresenter::chooseWindow);
    connect(view, &ui::SliceView::windowDragged, this, &SlicesPresenter::dragWindow);
    connect(view, &ui::SliceView::hovered, this,
            [this, &slice](const std::optional<dvec3>& placeMm) { showPointed(slice, placeMm); });
    connect(view, &ui::SliceView::menuRequested, this, [this, &slice](QPoint place) { openMenu(slice, place); });
    connect(view, &ui::SliceView::aloneRequested, this, [this, view] { window().views().toggleAlone(view); });
}

/// Opens the context menu of a slice: its window, what can be measured on it, and its view.
void SlicesPresenter::openMenu(Slice& slice, QPoint place) {
    if (!scan_.volume())
        return;
    auto* menu = new QMenu(slice.view);
    menu->setObjectName("sliceMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addMenu(windows_);
    menu->addSeparator();
    for (const char* tool : {"distance", "angle"})
        menu->addAction(window().findChild<QAction*>(tool));
    menu->addSeparator();
    connect(menu->addAction(Texts::tr("&Fit the slice to its view")), &QAction::triggered, this,
            [this, &slice] { fit(slice); });
    connect(menu->addAction(Texts::tr("Slice &alone, or all views")), &QAction::triggered, this,
            [this, &slice] { window().views().toggleAlone(slice.view); });
    connect(menu->addAction(Texts::tr("&Copy slice")), &QAction::triggered, this, [this, &slice] { copy(slice); });
    menu->popup(slice.view->mapToGlobal(place));
}

/// Copies what the view shows. A slice that is still coarse is made in full first.
void SlicesPresenter::copy(Slice& slice) {
    const std::optional<ui::ShownSlice>& shown = slice.view->slice();
    if (shown && shown->isCoarse() && scan_.volume()) {
        const SliceJob::Request full{
            .scan = scan_, .plane = shown->plane, .window = document().plan().navigation.window, .tint = tint_};
        show(slice, SliceJob::madeNow(full), full.plane, full.window);
    }
    QGuiApplication::clipboard()->setPixmap(slice.view->grab());
    window().status().showForAWhile(ui::MainWindow::tr("Copied"));
}

/// Shows the whole slice.
void SlicesPresenter::fit(const Slice& slice) {
    Navigation navigation = document().plan().navigation;
    framingOf(navigation, slice) = {};
    document().navigate(navigation);
}

SliceFraming& SlicesPresenter::framingOf(Navigation& navigation, const Slice& slice) const {
    return navigation.framings[std::size_t(slice.view->plane())];
}

void SlicesPresenter::setLayout(ViewLayout layout) {
    Navigation navigation = document().plan().navigation;
    if (navigation.layout == layout)
        return showLayout(layout);  // a view may be shown alone
    navigation.layout = layout;
    document().navigate(navigation);
}

void SlicesPresenter::showLayout(ViewLayout layout) {
    window().views().setLayout(layout);
    layouts_[std::size_t(layout)]->setChecked(true);
    requestAll(false);
}

void SlicesPresenter::showSlices() {
    if (!window().views().showsSlices())
        setLayout(ViewLayout::beside);
}

void SlicesPresenter::focusOne() {
    if (std::ranges::none_of(slices_, [](const Slice& slice) { return slice.view->hasFocus(); }))
        view(AnatomicalPlane::axial).setFocus(Qt::ShortcutFocusReason);
}

void SlicesPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        offerWindows_->setEnabled(document().hasVolume());
        offerPresets(*windows_, !document().hasVolume() || unitOf(*document().seen()).isHu);
        const bool hasArrived = document().hasVolume() && scan_.arriving();  // its slices stay until they are replaced
        for (Slice& slice : slices_)
            if (!hasArrived)
                slice.view->clear();
        arrival_->end();
    }
    if (has(changes, Changes::series | Changes::table))
        setScan(document().hasVolume() ? SlicedScan(document().seen()) : SlicedScan());
    if (has(changes, Changes::arrival)) {
        setScan(document().arriving());
        arrival_->begin();
    }
    if (has(changes, Changes::layout))
        showLayout(document().plan().navigation.layout);
    if (!has(changes, Changes::series | Changes::arrival | Changes::table | Changes::navigation))
        return;
    for (Slice& slice : slices_)
        slice.view->setCrosshair(document().plan().navigation.crosshairMm);
    // A single step is shown in full at once: only what follows it soon is a move.
    const bool moves = !has(changes, Changes::series | Changes::arrival | Changes::table);
    requestAll(moves && atRest_.isActive());
    if (moves)
        atRest_.start();
}

/// Takes the scan whose slices are shown.
void SlicesPresenter::setScan(SlicedScan scan) {
    scan_ = std::move(scan);
    for (Slice& slice : slices_)
        slice.stack = scan_ ? std::optional(SliceStack(scan_.geometry(), slice.view->plane())) : std::nullopt;
}

void SlicesPresenter::setTint(SliceTint tint) {
    if (tint == tint_)
        return;
    tint_ = std::move(tint);
    requestAll(false);
}

/// Shows what has arrived since the last time.
void SlicesPresenter::showArrived() {
    scan_ = SlicedScan(document().arriving());
    requestAll(false);
}

void SlicesPresenter::releaseVolume() {
    atRest_.stop();
    arrival_->end();
    bridge().setYielding(false);
    for (Slice& slice : slices_) {
        slice.job.drop();
        slice.stack.reset();
    }
    scan_ = {};
    tint_ = {};
}

/// Returns the plane that the view of `slice` shows; none without a volume.
std::optional<SlicePlane> SlicesPresenter::planeOf(const Slice& slice) const {
    if (!slice.stack)
        return std::nullopt;
    const Navigation& navigation = document().plan().navigation;
    return framed(slice.stack->at(slice.stack->positionMm(navigation.crosshairMm)),
                  navigation.framings[std::size_t(slice.view->plane())], slice.view->sizeInPixels());
}

/// Computes the slice that the view should show, unless it is not on the screen. `moving`: a large one is coarse.
/// Returns whether it is.
bool SlicesPresenter::request(Slice& slice, bool moving) {
    const auto plane = planeOf(slice);
    const bool isEmpty = scan_.arriving() && scan_.arriving()->arrived() == 0;  // its first slice comes at once
    if (!plane || !scan_ || isEmpty || !slice.view->isVisible())
        return false;
    const bool coarse = moving && plane->size.x * plane->size.y > kMostMovingPixels;
    slice.job.make({scan_, *plane, document().plan().navigation.window, coarse, tint_});
    return coarse;
}

/// Computes all slices that are on the screen. Large ones that move get the processor for themselves.
void SlicesPresenter::requestAll(bool moving) {
    bool large = false;
    for (Slice& slice : slices_)
        large = request(slice, moving) || large;
    bridge().setYielding(large);
}

void SlicesPresenter::show(Slice& slice, const QImage& grey, const SlicePlane& plane, const GreyWindow& window) {
    if (!slice.stack)
        return;
    if (scan_.arriving())
        document().seeArrived();
    ui::ShownSlice shown{grey, plane, textsOf(slice, plane, window)};
    for (const Slice& other : slices_) {
        if (&other == &slice || !other.stack)
            continue;
        const dvec2 line = lineOf(*other.stack, plane);
        (std::abs(line.x) > std::abs(line.y) ? shown.lineAcross : shown.lineDown) = line;
    }
    slice.view->setSlice(shown);
}

QStringList SlicesPresenter::textsOf(const Slice& slice, const SlicePlane& plane, const GreyWindow& window) const {
    const int index = nearestSlice(*slice.stack, plane.middleMm());
    const ValueUnit unit = scan_ ? scan_.unit() : ValueUnit();
    const GreyWindow values = inValues(window, unit);
    const int decimals = unit.decimals();
    QStringList texts{
        nameOf(slice.view->plane(), index + 1, slice.stack->count()),
        Texts::tr("Window %1 / %2 %3")
            .arg(ui::number(values.centre, decimals), ui::number(values.width, decimals), ui::unitName(unit))};
    if (const auto& arriving = scan_.arriving())
        texts << Texts::tr("%1 of %2 slices read; hatched: not read yet")
                     .arg(arriving->arrived())
                     .arg(arriving->geometry().size.z);
    return texts;
}

/// Shows the value and the place under the pointer. The value is that of the renderer there.
void SlicesPresenter::showPointed(Slice& slice, const std::optional<dvec3>& placeMm) {
    const auto plane = planeOf(slice);
    if (!placeMm || !plane || !scan_)
        return slice.view->setPointed({});
    const double voxel = huAt(scan_, *placeMm);
    slice.view->setPointed(std::isnan(voxel) ? Texts::tr("outside the scan")
                           : voxel == kNotArrived
                               ? Texts::tr("not read yet")
                               : Texts::tr("%1 at %2").arg(ui::valueText(scan_.unit(), voxel), placeText(*placeMm)));
}

/// Chooses the window of a digit: a preset, the window of the files (9), or the whole range (0).
void SlicesPresenter::chooseWindow(char key) {
    if (!scan_ || (key == '0' && !scan_.volume()))
        return;
    if (key >= '1' && key <= '8' && !scan_.unit().isHu)
        return window().status().showForAWhile(whyNoPresets());
    const GreyWindow& current = document().plan().navigation.window;
    setWindow(key == '9'   ? document().firstWindow()
              : key == '0' ? wholeRange(*scan_.volume())
                           : presetAfter(key, current).value_or(current));
}

/// Makes the window wider or narrower, and darker or brighter, by parts of the view's height.
void SlicesPresenter::dragWindow(double wider, double brighter) {
    constexpr double kPerHeight = 4;   // a drag over the view's height changes the width by a factor of exp(4)
    constexpr double kNarrowest = 1;   // voxels differ by no less
    constexpr double kWidest = 65536;  // and by no more
    Navigation navigation = document().plan().navigation;
    GreyWindow& window = navigation.window;
    window.centre -= 2 * brighter * window.width;
    window.width = std::clamp(window.width * std::exp(kPerHeight * wider), kNarrowest, kWidest);
    window.centre = std::clamp(window.centre, -kWidest, kWidest);
    document().navigate(navigation);
}

}  // namespace pdr::app
