#include "app/presenters/place_menu_presenter.h"

#include <cmath>

#include "app/presenters/camera_presenter.h"
#include "app/presenters/crosshair_presenter.h"
#include "app/presenters/place_text.h"
#include "app/presenters/tissue_presenter.h"
#include "render/prepare/layers_text.h"
#include "ui/text/language.h"
#include "ui/text/room_text.h"
#include "ui/text/value_text.h"

namespace pdr::app {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(PlaceMenu)
};

}  // namespace

PlaceMenuPresenter::PlaceMenuPresenter(const Workspace& workspace, const PlaceFeatures& features, PlaceScenes& scenes)
    : Presenter(workspace), features_(features), job_(scenes) {
    connect(&window(), &ui::MainWindow::imageMenuOpens, this, &PlaceMenuPresenter::fill);
    connect(&job_, &PlaceJob::found, this, &PlaceMenuPresenter::showPlace);
}

/// Puts the entries above the others. What lies at the place is filled in when it has been found.
void PlaceMenuPresenter::fill(QMenu* menu, QPointF place) {
    if (!document().hasVolume())
        return;
    QAction* next = menu->actions().value(0);
    const auto add = [&](const QString& text) {
        auto* action = new QAction(text, menu);
        menu->insertAction(next, action);
        return action;
    };
    heading_ = add(Texts::tr("Finding what is here..."));
    heading_->setObjectName("placeHere");
    heading_->setEnabled(false);
    connect(add(Texts::tr("Set the &crosshair here")), &QAction::triggered, this,
            [this, place] { features_.crosshair.moveTo(place); });
    connect(add(Texts::tr("&Focus here")), &QAction::triggered, this,
            [this, place] { features_.camera.focusAt(place); });
    connect(add(Texts::tr("Show &this tissue")), &QAction::triggered, this,
            [this, place] { features_.tissue.pick(place); });
    for (const char* tool : {"distance", "angle"})
        menu->insertAction(next, window().findChild<QAction*>(tool));
    menu->insertSeparator(next);
    job_.pick(document().scene(), place);
}

void PlaceMenuPresenter::showPlace(const LayersUnder& under) {
    if (heading_)
        heading_->setText(textOf(under));
}

QString PlaceMenuPresenter::textOf(const LayersUnder& under) const {
    if (under.seen == SeenAt::choice)
        return Texts::tr("Several layers shine through each other here");
    if (under.seen != SeenAt::place || !document().hasVolume())
        return ui::sentence(layersText(under));
    const dvec3 place = under.layers.front().placeMm;
    const SlicedScan scan = document().seen();
    const double voxel = huAt(scan, place);
    return std::isnan(voxel) ? placeText(place)
                             : Texts::tr("%1 at %2").arg(ui::valueText(scan.unit(), voxel), placeText(place));
}

}  // namespace pdr::app
