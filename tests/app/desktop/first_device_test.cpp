/// The device with which the window begins, that of an image for a file, and what is said where it is another one than
/// the user wants.

#include <QTest>

#include "app/rendering/device_choice.h"
#include "app/rendering/first_device.h"

using namespace pdr;

class FirstDeviceTest : public QObject {
    Q_OBJECT

  private slots:
    void theOneThatIsAskedForComesBeforeTheLastOne() {
        const auto first = app::firstDevice("emulated", "cpu", 1);
        QVERIFY(first && first->notice.empty());
        QCOMPARE(first->device->info().name, "emulated");
    }
    void theLastOneIsOpenedAgain() {
        const auto first = app::firstDevice("", "emulated", 1);
        QVERIFY(first && first->notice.empty());
        QCOMPARE(first->device->info().name, "emulated");
    }
    void anotherOneThanTheLastIsSaid() {
        const auto first = app::firstDevice("", "cuda:77", 1);
        QVERIFY(bool(first));
        QVERIFY2(first->notice.find("renders, since the device chosen last cannot be used: cuda:77: ") != Text::npos,
                 first->notice.c_str());
    }
    void anotherOneThanIsAskedForIsRefused() {
        const auto first = app::firstDevice("cuda:77", "cpu", 1);
        QVERIFY(!first);
        QCOMPARE(first.error().where, "cuda:77");
    }
    void theCpuRendersForAFileWhereTheDeviceIsGone() {
        std::vector<Error> told;
        const app::DeviceChoice devices(1);
        const auto device = devices.forFinalRender("cuda:77", [&](const Error& why) { told.push_back(why); })();
        QVERIFY(device && (*device)->info().hostMemory);
        QVERIFY(told.size() == 1 && told[0].where == "cuda:77");
    }
};

QTEST_APPLESS_MAIN(FirstDeviceTest)
#include "first_device_test.moc"
