#include "app/presenters/crosshair_presenter.h"

#include <QCursor>
#include <QMenu>
#include <chrono>

#include "render/prepare/layers_text.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

/// What lies in front is computed once edits rest, since it takes time from the image.
constexpr auto kAtRest = std::chrono::milliseconds(250);

/// Changes after which something else may hide the place.
constexpr Changes kHides = Changes::crosshair | Changes::series | Changes::camera | Changes::look | Changes::table |
                           Changes::clip | Changes::model | Changes::mask;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Crosshair)
};

}  // namespace

CrosshairPresenter::CrosshairPresenter(const Workspace& workspace) : Presenter(workspace) {
    window().viewport().tools().add(layer_);
    atRest_.setSingleShot(true);
    atRest_.setInterval(kAtRest);
    connect(&atRest_, &QTimer::timeout, this, &CrosshairPresenter::lookAgain);
    connect(&window().viewport(), &ui::Viewport::clicked, this, &CrosshairPresenter::pick);
    connect(&window().views(), &ui::ViewGrid::layoutChanged, this, [this] { showDocument(Changes::crosshair); });
    connect(&picks_, &PlaceJob::found, this, &CrosshairPresenter::moveToLayer);
    connect(&looks_, &PlaceJob::seen, this, &CrosshairPresenter::showHidden);
}

void CrosshairPresenter::showDocument(Changes changes) {
    const bool shown = document().hasVolume() && window().views().layout() != ui::ViewLayout::image;
    layer_.setPlace(shown ? std::optional(document().plan().navigation.crosshairMm) : std::nullopt);
    if (shown && has(changes, kHides))
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
    if (layer_.place())
        picks_.pick(document().scene(), place);
}

void CrosshairPresenter::moveToLayer(const LayersUnder& under) {
    if (under.seen == SeenAt::place)
        return document().moveCrosshair(under.layers.front().placeMm);
    if (under.seen == SeenAt::choice)
        return offer(under);
    window().status().showForAWhile(ui::sentence(layersText(under)));
}

/// Lets the user choose one of several layers: none of them is what the point shows.
void CrosshairPresenter::offer(const LayersUnder& under) {
    auto* menu = new QMenu(&window());
    menu->setObjectName("layers");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const double nearest = under.layers.front().depthMm;
    for (const SeenLayer& layer : under.layers) {
        const QString share = ui::number(100 * layer.share, 0);
        const QString text =
            layer.depthMm == nearest
                ? Texts::tr("In front: %1 % of the light").arg(share)
                : Texts::tr("%1 mm behind: %2 % of the light").arg(ui::number(layer.depthMm - nearest, 0), share);
        connect(menu->addAction(text), &QAction::triggered, this,
                [this, place = layer.placeMm] { document().moveCrosshair(place); });
    }
    menu->popup(QCursor::pos());
}

void CrosshairPresenter::lookAgain() {
    if (layer_.place())
        looks_.look(document().scene(), *layer_.place());
}

void CrosshairPresenter::showHidden(dvec3 placeMm, const std::optional<HiddenBy>& hiddenBy) {
    if (layer_.place() != placeMm || !hiddenBy)
        return;
    if (hiddenBy->cutAway)
        return layer_.setInFront(ui::InFront::cut, Texts::tr("not shown here"));
    if (!hiddenBy->hidden())
        return layer_.setInFront(ui::InFront::little, {});
    layer_.setInFront(ui::InFront::tissue, Texts::tr("behind %1 mm of tissue").arg(ui::number(hiddenBy->tissueMm, 0)));
}

}  // namespace pdr::app
