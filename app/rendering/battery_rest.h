#pragma once
/// Pauses rendering once when the machine starts to run on battery, and resumes it on mains power unless the user has
/// resumed it before.

#include <QObject>
#include <QTimer>
#include <filesystem>

namespace pdr::app {

class RenderBridge;

class BatteryRest : public QObject {
    Q_OBJECT

  public:
    /// Checks at once and every 10 seconds. `supplies`: see onBattery(); empty: the machine counts as running on mains
    /// power.
    BatteryRest(RenderBridge& bridge, std::filesystem::path supplies);

    /// Whether rendering is paused because of the battery.
    bool rests() const { return rests_; }
    /// Checks the power supply now.
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
