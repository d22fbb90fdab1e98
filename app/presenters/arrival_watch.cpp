#include "app/presenters/arrival_watch.h"

#include <chrono>
#include <utility>

namespace pdr::app {
namespace {

/// In between, the cores read.
constexpr auto kOften = std::chrono::milliseconds(100);

/// A slice stands in for the image if, after this time, less than this part of the volume has arrived. Else the image
/// is there before one could look at the slice.
constexpr qint64 kStandInMs = 300;
constexpr double kStandInPart = 0.25;

}  // namespace

ArrivalWatch::ArrivalWatch(const Workspace& workspace, QWidget& axial) : workspace_(workspace), axial_(axial) {
    often_.setInterval(kOften);
    connect(&often_, &QTimer::timeout, this, [this] {
        standIn();
        emit more();
    });
}

void ArrivalWatch::begin() {
    sinceBegin_.start();
    often_.start();
}

void ArrivalWatch::end() {
    often_.stop();
    ui::ViewGrid& views = workspace_.window.views();
    if (std::exchange(standsIn_, false) && views.alone() == &axial_)
        views.toggleAlone(&axial_);
}

void ArrivalWatch::standIn() {
    const ArrivingVolume& volume = *workspace_.document.arriving();
    ui::ViewGrid& views = workspace_.window.views();
    const bool isSoonThere = volume.arrived() >= kStandInPart * volume.geometry().size.z;
    if (standsIn_ || views.alone() || views.layout() != ViewLayout::image || sinceBegin_.elapsed() < kStandInMs ||
        isSoonThere)
        return;
    standsIn_ = true;
    views.toggleAlone(&axial_);
}

}  // namespace pdr::app
