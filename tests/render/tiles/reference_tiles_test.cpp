#include <QTest>

#include "render/device/device_list.h"
#include "render/tiles/reference_tiles.h"

using namespace pdr;

/// The images by which two machines are found to make the same bits.
class ReferenceTilesTest : public QObject {
    Q_OBJECT

  private slots:
    void areTheSameOnEveryDevice_data() {
        QTest::addColumn<QString>("device");
        QTest::addColumn<int>("threads");
        QTest::newRow("cpu, 1 thread") << "cpu" << 1;
        QTest::newRow("cpu, 3 threads") << "cpu" << 3;
        QTest::newRow("emulated GPU") << "emulated" << 2;
    }
    void areTheSameOnEveryDevice() {
        QFETCH(const QString, device);
        QFETCH(const int, threads);
        const auto one = makeCpuDevice(2), other = *openDevice(device.toStdString(), threads);
        const auto bits = *referenceTiles(*one);
        QVERIFY(bits.size() > 6 * 512 * 60);
        const auto others = *referenceTiles(*other);
        std::size_t same = 0;
        while (same < bits.size() && bits[same] == others.at(same))
            ++same;
        QCOMPARE(same, bits.size());
    }
};

QTEST_APPLESS_MAIN(ReferenceTilesTest)
#include "reference_tiles_test.moc"
