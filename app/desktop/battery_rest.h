#pragma once
/// Rendering rests on battery: it is paused once when the machine begins to run on it, and goes on with the mains
/// unless the hand has done so before.

#include <QObject>
#include <QTimer>
#include <filesystem>

namespace pdr::app {

class RenderBridge;

class BatteryRest : public QObject {
    Q_OBJECT

  public:
    /// `supplies`: see onBattery(); empty: the machine is taken to have mains. Looks at once and every few seconds.
    BatteryRest(RenderBridge& bridge, std::filesystem::path supplies);

    /// The image is paused for the battery.
    bool rests() const { return rests_; }
    /// Looks now.
    void look();

  signals:
    void restsChanged();

  private:
    void setRests(bool rests);

    RenderBridge& bridge_;
    std::filesystem::path supplies_;
    QTimer timer_;
    bool onBattery_ = false;
    bool rests_ = false;
};

}  // namespace pdr::app
