#include "app/presenters/crosshair_presenter.h"

#include <chrono>

#include "app/presenters/slices_presenter.h"
#include "ui/text/language.h"

namespace pdr::app {
namespace {

/// What lies in front is computed once edits rest, since it takes time from the image.
constexpr auto kAtRest = std::chrono::milliseconds(250);

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Crosshair)
};

}  // namespace

CrosshairPresenter::CrosshairPresenter(const Workspace& workspace, SlicesPresenter& slices, PlaceScenes& scenes)
    : Presenter(workspace), slices_(slices), picks_(workspace, scenes), looks_(scenes) {
    addAction();
    window().viewport().tools().add(layer_);
    atRest_.setSingleShot(true);
    atRest_.setInterval(kAtRest);
    connect(&atRest_, &QTimer::timeout, this, &CrosshairPresenter::lookAgain);
    connect(&window().viewport(), &ui::Viewport::clicked, this, &CrosshairPresenter::pick);
    connect(&window().views(), &ui::ViewGrid::layoutChanged, this, [this] { showDocument(Changes::crosshair); });
    connect(&picks_, &ImagePick::picked, this,
            [this](const PickedPlace& place) { document().moveCrosshair(place.layer.placeMm); });
    connect(&looks_, &PlaceJob::seen, this, &CrosshairPresenter::showHidden);
}

void CrosshairPresenter::addAction() {
    action_ = slices_.menu().addAction(Texts::tr("Set the &crosshair"), QKeySequence(Qt::Key_J));
    action_->setObjectName("crosshair");
    action_->setToolTip(Texts::tr("The next click on the image moves the slices to what is seen there."));
    action_->setCheckable(true);
    window().addAction(action_);  // so that its key works while the menu bar is hidden
    window().viewport().tools().add(click_);
    connect(action_, &QAction::triggered, &click_, &ui::PickTool::setActive);
    connect(&click_, &ui::PickTool::activeChanged, action_, &QAction::setChecked);
    connect(&click_, &ui::PickTool::picked, this, &CrosshairPresenter::moveTo);
}

void CrosshairPresenter::moveTo(QPointF place) {
    if (!document().hasVolume())
        return;
    slices_.showSlices();
    picks_.pick(place);
}

void CrosshairPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series)) {
        action_->setEnabled(document().hasVolume());
        click_.setActive(false);
    }
    const bool shown = document().hasVolume() && window().views().layout() != ViewLayout::image;
    layer_.setPlace(shown ? std::optional(document().plan().navigation.crosshairMm) : std::nullopt);
    if (shown && has(changes, kHides | Changes::crosshair))
        atRest_.start();
}

void CrosshairPresenter::releaseVolume() {
    atRest_.stop();
    picks_.drop();
    looks_.drop();
    layer_.setPlace(std::nullopt);
}

/// Moves the crosshair to what is seen at `place`, while slices are shown.
void CrosshairPresenter::pick(QPointF place) {
    if (layer_.place() && followsClicks_)
        picks_.pick(place);
}

void CrosshairPresenter::lookAgain() {
    if (layer_.place())
        looks_.look(document().scene(), {*layer_.place()});
}

void CrosshairPresenter::showHidden(const std::vector<dvec3>& placesMm,
                                    const std::vector<std::optional<HiddenBy>>& hidden) {
    const std::optional<HiddenBy>& hiddenBy = hidden.front();
    if (layer_.place() != placesMm.front() || !hiddenBy)
        return;
    if (hiddenBy->cutAway)
        return layer_.setInFront(ui::InFront::cut, Texts::tr("not shown here"));
    if (!hiddenBy->hidden())
        return layer_.setInFront(ui::InFront::little, {});
    layer_.setInFront(ui::InFront::tissue, Texts::tr("behind %1 mm of tissue").arg(ui::number(hiddenBy->tissueMm, 0)));
}

}  // namespace pdr::app
