#pragma once
/// The cost table of the effects, and leaving out those that nobody would see.

#include "app/presenters/presenter.h"
#include "ui/accuracy/effect_ledger.h"

namespace pdr::app {

class EffectsPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit EffectsPresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;

  private:
    void showLedger();
    void leaveOutUnseen();

    ui::EffectLedger* panel_;
};

}  // namespace pdr::app
