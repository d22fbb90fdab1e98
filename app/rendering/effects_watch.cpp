#include "app/rendering/effects_watch.h"

#include <QPointer>
#include <utility>

#include "app/rendering/render_bridge.h"

namespace pdr::app {

void EffectsWatch::setWatching(bool watching) {
    watching_ = watching;
    take(nullptr);
    if (!watching)
        return bridge_.observeEffects({});
    bridge_.observeEffects([self = QPointer(this)](const std::shared_ptr<const EffectCosts>& table) {
        if (self && self->watching_)  // a table may arrive after watching has ended
            self->take(table);
    });
}

void EffectsWatch::take(const std::shared_ptr<const EffectCosts>& table) {
    if (std::exchange(table_, table) != table)
        emit changed();
}

}  // namespace pdr::app
