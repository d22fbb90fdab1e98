#include <QtTest>

#include <QTemporaryDir>

#include <unistd.h>

#include <cmath>
#include <fstream>
#include <vector>

#include "render/volume/clamp.h"
#include "render/volume/raw_file.h"

using namespace pdr;

class RawFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    template <class T>
    RawFile written(const std::vector<T>& values, RawFile::Type type, ivec3 size) {
        const std::filesystem::path path = folder_.filePath("volume.raw").toStdString();
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(values.data()), std::streamsize(values.size() * sizeof(T)));
        return {path, type, size, {0.5, 1, 2}, std::nullopt};
    }

  private slots:
    void int16IsTakenAsItIs() {
        const std::vector<std::int16_t> values{-1024, 0, 1, 32767, -32768, 7};
        const auto volume = loadRaw(written(values, RawFile::Type::int16, {3, 2, 1}));
        QVERIFY(bool(volume));
        QVERIFY(std::equal(values.begin(), values.end(), volume->voxels().begin()));
        QCOMPARE(volume->lowestHu(), std::int16_t(-32768));
    }

    void otherTypesBecomeHounsfieldUnits() {
        const auto bytes = loadRaw(written<std::uint8_t>({0, 255}, RawFile::Type::uint8, {2, 1, 1}));
        QCOMPARE(bytes->voxels()[1], std::int16_t(255));
        const auto words = loadRaw(written<std::uint16_t>({0, 32767}, RawFile::Type::uint16, {2, 1, 1}));
        QCOMPARE(words->voxels()[1], std::int16_t(32767));
        const auto floats = loadRaw(written<float>({-1.4f, 2.6f}, RawFile::Type::float32, {2, 1, 1}));
        QCOMPARE(floats->voxels()[0], std::int16_t(-1));
        QCOMPARE(floats->voxels()[1], std::int16_t(3));
    }

    void valuesThatDoNotFitAreRefused() {
        const auto words = loadRaw(written<std::uint16_t>({0, 40000}, RawFile::Type::uint16, {2, 1, 1}));
        QVERIFY(!words && words.error().what.find("voxel 1 holds 40000") != std::string::npos);
        QVERIFY(!loadRaw(written<float>({NAN, 0}, RawFile::Type::float32, {2, 1, 1})));
    }

    void theBoxBeginsAtZeroUnlessSaidOtherwise() {
        RawFile file = written<std::int16_t>({1, 2}, RawFile::Type::int16, {2, 1, 1});
        QVERIFY(loadRaw(file)->geometry().centreMm() == dvec3(0.5, 0.5, 1));
        file.originMm = dvec3(10, 20, 30);
        QVERIFY(dvec3(loadRaw(file)->geometry().patientFromIndex[3]) == dvec3(10, 20, 30));
    }

    void aWrongSizeIsToldInBytes() {
        const auto volume = loadRaw(written<std::int16_t>({1, 2, 3}, RawFile::Type::int16, {2, 1, 1}));
        QVERIFY(!volume);
        QVERIFY2(volume.error().what.find("6 bytes") != std::string::npos, volume.error().what.c_str());
        QVERIFY(volume.error().what.find(" 4") != std::string::npos);
    }

    void hugeDimensionsAreRefusedBeforeMemoryIsAsked() {
        RawFile file = written<std::int16_t>({1}, RawFile::Type::int16, {65536, 65536, 65536});
        QVERIFY(!loadRaw(file));
    }

    void aMissingFileIsNamed() {
        const auto volume = loadRaw({"/nowhere/volume.raw", RawFile::Type::int16, {1, 1, 1}, dvec3(1), std::nullopt});
        QVERIFY(!volume);
        QCOMPARE(volume.error().where, std::string("/nowhere/volume.raw"));
    }

    void aFileThatMayNotBeReadSaysSo() {
        const RawFile file = written<std::int16_t>({1, 2}, RawFile::Type::int16, {2, 1, 1});
        QVERIFY(QFile::setPermissions(folder_.path(), QFile::Permissions(0x7755)));
        QVERIFY(QFile::setPermissions(folder_.filePath("volume.raw"), QFile::Permissions()));
        const bool root = geteuid() == 0;  // who may read everything
        QVERIFY(!root || seteuid(65534) == 0);
        const auto volume = loadRaw(file);
        QVERIFY(!root || seteuid(0) == 0);
        QFile::remove(folder_.filePath("volume.raw"));
        QVERIFY(!volume);
        QCOMPARE(QString::fromStdString(volume.error().hint), QString("Check that you may read it."));
    }

    void voxelsAreNoCloserThanAnyScansAre() {
        RawFile file = written<std::int16_t>({1, 2}, RawFile::Type::int16, {2, 1, 1});
        for (const dvec3 spacing : {dvec3(1, 1, 1e-300), dvec3(1, 0.9e-6, 1), dvec3(2e6, 1, 1), dvec3(1, 1, NAN)}) {
            file.spacingMm = spacing;
            const auto volume = loadRaw(file);
            QVERIFY(!volume);
            QVERIFY2(volume.error().what.find("from 1e-06 to 1e+06") != std::string::npos, volume.error().what.c_str());
        }
        file.spacingMm = {1e-6, 1e6, 1};
        QVERIFY(bool(loadRaw(file)));
    }

    void clampingKeepsThePadding() {
        Volume volume(VolumeGeometry::aligned({3, 1, 1}, dvec3(1), dvec3(0)), {-1024, 200, 2000}, {true, false, false});
        const Volume cut = clamped(volume, std::pair(150, 1500));
        QCOMPARE(cut.voxels()[0], std::int16_t(150));
        QCOMPARE(cut.voxels()[1], std::int16_t(200));
        QCOMPARE(cut.voxels()[2], std::int16_t(1500));
        QVERIFY(cut.isPadding(0) && !cut.isPadding(1));
        QCOMPARE(clamped(volume, std::nullopt).voxels()[0], std::int16_t(-1024));
    }
};

QTEST_APPLESS_MAIN(RawFileTest)
#include "raw_file_test.moc"
