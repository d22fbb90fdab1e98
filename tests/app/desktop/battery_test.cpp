/// A laptop on battery rests: what the machine tells of its power, and what rendering makes of it.

#include <QDir>
#include <QFile>
#include <QTest>

#include "app/rendering/battery_rest.h"
#include "app/rendering/power_supply.h"
#include "tests/support/desktop/desktop_trial.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// A folder of power supplies as Linux has them.
struct Supplies {
    void set(const QString& supply, const QMap<QString, QString>& files) const {
        QVERIFY(QDir(folder.path()).mkpath(supply));
        for (auto file = files.begin(); file != files.end(); ++file) {
            QFile one(folder.filePath(supply + '/' + file.key()));
            QVERIFY(one.open(QFile::WriteOnly));
            one.write(file.value().toUtf8() + '\n');
        }
    }
    std::filesystem::path path() const { return ui::fromQt(folder.path()); }
    bool empties() const { return onBattery(path()); }

    QTemporaryDir folder;
};

class TestBattery : public QObject {
    Q_OBJECT

  private slots:
    void aBatteryCountsWhereItDischargesWithoutMains();
    void renderingRestsOnceOnBattery();
    void aPauseOfTheHandIsLeftAlone();
};

void TestBattery::aBatteryCountsWhereItDischargesWithoutMains() {
    QVERIFY(!onBattery("/there/is/no/such/folder"));
    const Supplies supplies;
    QVERIFY(!supplies.empties());
    supplies.set("hidpp_battery_0", {{"type", "Battery"}, {"scope", "Device"}, {"status", "Discharging"}});
    QVERIFY(!supplies.empties());  // a mouse
    supplies.set("AC", {{"type", "Mains"}, {"online", "1"}});
    supplies.set("BAT0", {{"type", "Battery"}, {"status", "Full"}});
    QVERIFY(!supplies.empties());
    supplies.set("BAT0", {{"status", "Discharging"}});
    QVERIFY(!supplies.empties());  // a weak adapter: the machine is not on its battery alone
    supplies.set("AC", {{"online", "0"}});
    QVERIFY(supplies.empties());
    supplies.set("ucsi-source-psy-1", {{"type", "USB"}, {"scope", "System"}, {"online", "1"}});
    QVERIFY(!supplies.empties());
    supplies.set("ucsi-source-psy-1", {{"online", "0"}});
    supplies.set("BAT0", {{"status", "Charging"}});
    QVERIFY(!supplies.empties());
}

static void unplug(const Supplies& supplies, bool unplugged) {
    supplies.set("AC", {{"type", "Mains"}, {"online", unplugged ? "0" : "1"}});
    supplies.set("BAT0", {{"type", "Battery"}, {"status", unplugged ? "Discharging" : "Charging"}});
}

void TestBattery::renderingRestsOnceOnBattery() {
    const Supplies supplies;
    unplug(supplies, false);
    RenderBridge bridge(makeCpuDevice(1), 1);
    BatteryRest battery(bridge, supplies.path());
    QVERIFY(!bridge.paused() && !battery.rests());
    unplug(supplies, true);
    battery.look();
    QVERIFY(bridge.paused() && battery.rests());
    bridge.setPaused(false);  // Space
    QVERIFY(!battery.rests());
    battery.look();
    QVERIFY(!bridge.paused());
    unplug(supplies, false);
    battery.look();
    unplug(supplies, true);
    battery.look();
    QVERIFY(bridge.paused());
    unplug(supplies, false);
    battery.look();
    QVERIFY(!bridge.paused() && !battery.rests());
}

void TestBattery::aPauseOfTheHandIsLeftAlone() {
    const Supplies supplies;
    unplug(supplies, false);
    RenderBridge bridge(makeCpuDevice(1), 1);
    BatteryRest battery(bridge, supplies.path());
    bridge.setPaused(true);
    for (const bool unplugged : {true, false}) {
        unplug(supplies, unplugged);
        battery.look();
        QVERIFY(bridge.paused() && !battery.rests());
    }
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestBattery)
#include "battery_test.moc"
