#include "app/presenters/effects_presenter.h"

#include "app/presenters/effect_cost_rows.h"

namespace pdr::app {

EffectsPresenter::EffectsPresenter(const Workspace& workspace)
    : Presenter(workspace), panel_(new ui::EffectCosts), watch_(bridge()) {
    const QAction* toggle = window().addPanel(panel_, {.name = "Effects",
                                                       .title = ui::WindowDocks::tr("Render cost by effect"),
                                                       .key = Qt::Key_F6,
                                                       .place = ui::PanelPlace::below,
                                                       .fixedHeight = true});
    connect(toggle, &QAction::toggled, &watch_, &EffectsWatch::setWatching);
    connect(&watch_, &EffectsWatch::changed, this, &EffectsPresenter::showEffectCosts);
    connect(panel_, &ui::EffectCosts::leaveOutChosen, this, &EffectsPresenter::leaveOutUnseen);
}

void EffectsPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series))
        showEffectCosts();
}

void EffectsPresenter::showEffectCosts() {
    const auto& effectCosts = watch_.table();
    if (!effectCosts || !document().hasVolume())
        return panel_->setRows({});
    panel_->setRows(effectRows(*effectCosts, leanSetup(document(), *effectCosts).leftOut));
}

void EffectsPresenter::leaveOutUnseen() {
    if (const auto& effectCosts = watch_.table(); effectCosts && document().hasVolume())
        document().setSetup(leanSetup(document(), *effectCosts).setup);
}

}  // namespace pdr::app
