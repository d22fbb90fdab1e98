#pragma once
/// The cost table of the effects, and leaving out those that nobody would see.

#include "app/presenters/presenter.h"
#include "app/rendering/effects_watch.h"
#include "ui/accuracy/effect_costs.h"

namespace pdr::app {

class EffectsPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit EffectsPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    EffectsWatch& watch() { return watch_; }

  private:
    void showEffectCosts();
    void leaveOutUnseen();

    ui::EffectCosts* panel_;
    EffectsWatch watch_;
};

}  // namespace pdr::app
