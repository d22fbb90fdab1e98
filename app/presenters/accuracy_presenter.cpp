#include "app/presenters/accuracy_presenter.h"

#include "app/presenters/image_cost.h"
#include "app/presenters/image_text.h"
#include "render/volume/sheared.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/status_text.h"

namespace pdr::app {
namespace {

ui::Holding holdingOf(const RenderBridge& bridge) {
    if (bridge.paused())
        return ui::Holding::paused;
    return bridge.reached() ? ui::Holding::reached : ui::Holding::no;
}

}  // namespace

AccuracyPresenter::AccuracyPresenter(const Workspace& workspace, std::filesystem::path powerSupplies)
    : Presenter(workspace), panel_(new ui::AccuracyPanel), battery_(bridge(), std::move(powerSupplies)) {
    const QAction* toggle = window().addPanel(panel_, {"Accuracy", ui::WindowDocks::tr("Accuracy"),
                                                       QKeySequence(Qt::SHIFT | Qt::Key_E), ui::PanelPlace::floating});
    connect(&window().status(), &ui::StatusLine::textClicked, toggle, &QAction::trigger);
    connectTarget();
    connectPause();
    bridge().setTarget(settings().target());
}

void AccuracyPresenter::connectTarget() {
    const ui::AccuracyStrip& strip = window().accuracyStatus().strip();
    connect(&bridge(), &RenderBridge::stopChanged, this, &AccuracyPresenter::showStop);
    connect(&strip, &ui::AccuracyStrip::targetChosen, this, [this](double levels) {
        bridge().setTarget(levels);
        settings().keepTarget(levels);
    });
    connect(&panel_->stop(), &ui::StopRow::ruleChosen, this, [this](const StopRule& rule) {
        bridge().setStop(rule);
        settings().keepTarget(rule.levels);
    });
}

void AccuracyPresenter::connectPause() {
    connect(window().menuActions().pause, &QAction::triggered, &bridge(), &RenderBridge::setPaused);
    connect(&window(), &ui::MainWindow::unseenChanged, &bridge(), &RenderBridge::setUnseen);
    connect(&bridge(), &RenderBridge::pausedChanged, this, [this](bool paused) {
        window().menuActions().pause->setChecked(paused);
        showStatus();
    });
    connect(&bridge(), &RenderBridge::preparingChanged, this, [this](bool preparing) {
        window().status().setText(preparing ? ui::MainWindow::tr("Preparing the GPU...") : QString());
        showStatus();
    });
    connect(&battery_, &BatteryRest::restsChanged, this, &AccuracyPresenter::showStatus);
}

void AccuracyPresenter::showDocument(Changes changes) {
    if (has(changes, Changes::series))
        window().menuActions().pause->setEnabled(document().hasVolume());
}

void AccuracyPresenter::showFrame(const std::shared_ptr<const Frame>& frame) {
    keepPlanningTime(settings(), *frame);
    showStatus();
}

void AccuracyPresenter::clearImage() {
    window().accuracyStatus().clear();
    panel_->clear();
}

void AccuracyPresenter::showStop(const StopRule& rule) {
    window().accuracyStatus().strip().setTarget(rule.levels);
    panel_->stop().setRule(rule);
    showStatus();
}

/// Returns the accuracy of the region while it gets all samples, else of the whole image.
ui::Accuracy AccuracyPresenter::accuracyOf(const Frame& frame) const {
    const ShownStatus shown = shownOf(frame);
    ui::Accuracy accuracy{shown.status,  frame.coarse,
                          shown.of,      frame.steps,
                          frame.seconds, holdingOf(bridge()),
                          frame.history, lastPlanningTime(settings(), frame, document().scene().film)};
    if (shown.of == ErrorOf::denoised)
        accuracy.film = frame.status;
    if (!frame.region || frame.region->reached)
        return accuracy;
    accuracy.status = frame.region->status;
    accuracy.of = frame.region->of;
    accuracy.steps = frame.region->steps;
    accuracy.points = frame.region->history;
    accuracy.box = true;
    return accuracy;
}

void AccuracyPresenter::showStatus() {
    const auto& frame = bridge().lastFrame();
    if (!frame || !document().hasVolume() || bridge().isPreparing())
        return;
    window().menuActions().pause->setChecked(bridge().paused() || bridge().reached());
    const ui::Accuracy accuracy = accuracyOf(*frame);
    const QString making = ui::makingText({QString::fromStdString(frame->device), frame->iterations, frame->efficiency,
                                           frame->status.samplesPerPixel, frame->iterationsPerSecond});
    const QStringList remarks = remarksOn(*frame, window().viewport().sizeInPixels());
    QStringList beside = remarks;
    for (const QString& text : denoisedTexts(*frame))  // they are shown on the image already
        beside.removeAll(text);
    if (battery_.rests())
        beside.prepend(ui::MainWindow::tr("Paused on battery (Space: continue)"));
    ui::AccuracyStatus& accuracyStatus = window().accuracyStatus();
    accuracyStatus.setAccuracy(accuracy);
    accuracyStatus.setMaking(making);
    accuracyStatus.setRemarks(beside);
    accuracyStatus.setLimit(ui::gridText(statedSpacingMm(document().scene().volume->geometry())));
    panel_->setAccuracy(accuracy, bridge().stop());
    panel_->setBias(remarks);
    panel_->setMaking(making);
}

}  // namespace pdr::app
