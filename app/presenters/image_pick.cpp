#include "app/presenters/image_pick.h"

#include <QCursor>
#include <QGuiApplication>
#include <QMenu>

#include "render/prepare/layers_text.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(Crosshair)
};

}  // namespace

ImagePick::ImagePick(const Workspace& workspace, PlaceScenes& scenes) : workspace_(workspace), job_(scenes) {
    connect(&job_, &PlaceJob::found, this, &ImagePick::take);
}

void ImagePick::pick(QPointF place) {
    free_ = QGuiApplication::keyboardModifiers().testFlag(Qt::AltModifier);
    job_.pick(workspace_.document.scene(), place);
}

void ImagePick::drop() {
    job_.drop();
}

void ImagePick::take(const LayersUnder& under) {
    if (under.seen == SeenAt::place)
        return emit picked({under.layers.front(), under.direction, free_});
    emit unclear();
    if (under.seen == SeenAt::choice)
        return offer(under);
    workspace_.window.status().showForAWhile(ui::sentence(layersText(under)));
}

/// Lets the user choose one of several layers: none of them is what the point shows.
void ImagePick::offer(const LayersUnder& under) {
    auto* menu = new QMenu(&workspace_.window);
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
                [this, place = PickedPlace{layer, under.direction, free_}] { emit picked(place); });
    }
    menu->popup(QCursor::pos());
}

}  // namespace pdr::app
