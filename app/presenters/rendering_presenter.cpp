#include "app/presenters/rendering_presenter.h"

#include <algorithm>

#include "render/device/device_list.h"
#include "ui/text/status_text.h"

namespace pdr::app {

RenderingPresenter::RenderingPresenter(const Workspace& workspace) : Presenter(workspace), panel_(new ui::RenderPanel) {
    window().addPanel(panel_, {"Rendering", ui::WindowDocks::tr("Rendering"), Qt::Key_F4});
    offerDevices();
    panel_->setPace(settings().pace());
    bridge().setPace(panel_->pace());
    connect(panel_, &ui::RenderPanel::estimatorChosen, &document(), &Document::setEstimator);
    connect(panel_, &ui::RenderPanel::scheduleChosen, &document(), &Document::setSchedule);
    connect(panel_, &ui::RenderPanel::paceChosen, this, [this](const FrameBudget& pace) {
        bridge().setPace(pace);
        settings().keepPace(pace);
    });
    connect(panel_, &ui::RenderPanel::deviceChosen, this, [this](const QString& name) {
        bridge().setDevice(name);
        settings().keepDevice(name);
    });
    connect(&bridge(), &RenderBridge::deviceChanged, panel_, &ui::RenderPanel::setDevice);
    connect(&bridge(), &RenderBridge::noticed, &window().message(), &ui::MessageBar::showNotice);
}

/// Fills the list of devices with those of this machine and the one in use, which may be none of them.
void RenderingPresenter::offerDevices() {
    const DeviceInfo& inUse = bridge().firstDevice();
    std::vector<DeviceInfo> devices = devicesHere();
    const auto known = std::ranges::find(devices, inUse.name, &DeviceInfo::name);
    if (known != devices.end())
        *known = inUse;
    else
        devices.push_back(inUse);
    QStringList names, texts;
    for (const DeviceInfo& device : devices) {
        names << QString::fromStdString(device.name);
        texts << ui::deviceText(names.back(), QString::fromStdString(device.details));
    }
    panel_->setDevices(names, texts);
    panel_->setDevice(QString::fromStdString(inUse.name));
}

void RenderingPresenter::showDocument(Changes changes) {
    if (!has(changes, Changes::rendering))
        return;
    panel_->setEstimator(document().setup().estimator);
    panel_->setSchedule(document().setup().schedule);
}

}  // namespace pdr::app
