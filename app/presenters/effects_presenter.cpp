#include "app/presenters/effects_presenter.h"

#include "app/presenters/ledger_content.h"

namespace pdr::app {

EffectsPresenter::EffectsPresenter(const Workspace& workspace) : Presenter(workspace), panel_(new ui::EffectLedger) {
    const QAction* toggle = window().addPanel(panel_, {.name = "Effects",
                                                       .title = ui::WindowDocks::tr("Render cost by effect"),
                                                       .key = Qt::Key_F6,
                                                       .place = ui::PanelPlace::below,
                                                       .fixedHeight = true});
    connect(toggle, &QAction::toggled, &bridge(), &RenderBridge::watchEffects);
    connect(&bridge(), &RenderBridge::ledgerChanged, this, &EffectsPresenter::showLedger);
    connect(panel_, &ui::EffectLedger::leaveOutChosen, this, &EffectsPresenter::leaveOutUnseen);
}

void EffectsPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series))
        showLedger();
}

void EffectsPresenter::showLedger() {
    const auto& ledger = bridge().lastLedger();
    if (!ledger || !document().hasVolume())
        return panel_->setRows({});
    panel_->setRows(effectRows(*ledger, leanSetup(document(), *ledger).leftOut));
}

void EffectsPresenter::leaveOutUnseen() {
    if (const auto& ledger = bridge().lastLedger(); ledger && document().hasVolume())
        document().setSetup(leanSetup(document(), *ledger).setup);
}

}  // namespace pdr::app
