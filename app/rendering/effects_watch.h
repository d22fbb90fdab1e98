#pragma once
/// The cost table of the effects of the image on the screen, measured while it is watched.

#include <QObject>
#include <memory>

#include "render/session/effect_costs.h"

namespace pdr::app {

class RenderBridge;

class EffectsWatch : public QObject {
    Q_OBJECT

  public:
    /// Watches the images of `bridge`, which must outlive this.
    explicit EffectsWatch(RenderBridge& bridge) : bridge_(bridge) {}

    /// The table, as far as it is known; null while it is not watched.
    const std::shared_ptr<const EffectCosts>& table() const { return table_; }

  public slots:
    /// Starts or ends measuring what effects cost, on the CPU.
    void setWatching(bool watching);

  signals:
    /// Emitted when table() has changed.
    void changed();

  private:
    void take(const std::shared_ptr<const EffectCosts>& table);

    RenderBridge& bridge_;
    std::shared_ptr<const EffectCosts> table_;
    bool watching_ = false;
};

}  // namespace pdr::app
