/// Images that were taken several times at each place: an entry for each phase, echo or diffusion gradient, with its
/// own images; or a refusal, where no value tells them apart.

#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

#include "dicom/import.h"
#include "tests/support/dicom/enhanced_file.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
using test::SliceFile;

namespace {

constexpr int kPlaces = 4;

int loadable(const ScanResult& scan) {
    return int(
        std::count_if(scan.series.begin(), scan.series.end(), [](const Series& s) { return s.verdict.loadable(); }));
}

/// Makes the k-th of several kinds of images what it is.
using Kind = std::function<void(DcmItem&)>;

Kind stating(const DcmTagKey& tag, const char* value) {
    return [=](DcmItem& item) { item.putAndInsertString(tag, value); };
}

/// States a diffusion in `item`, with a direction where `along` has three numbers.
void putDiffusion(DcmItem& item, double bValue, const std::vector<double>& along, bool inGroups) {
    DcmItem& group = inGroups ? test::itemIn(item, DCM_MRDiffusionSequence) : item;
    group.putAndInsertFloat64(DCM_DiffusionBValue, bValue);
    if (along.empty())
        return;
    DcmItem& direction = inGroups ? test::itemIn(group, DCM_DiffusionGradientDirectionSequence) : group;
    direction.putAndInsertFloat64Array(DCM_DiffusionGradientOrientation, along.data(), 3);
}

Kind diffusion(double bValue, const std::vector<double>& along, bool inGroups) {
    return [=](DcmItem& item) { putDiffusion(item, bValue, along, inGroups); };
}

/// Writes images of all kinds at each place, a file each; those of the n-th kind hold the number 100 n.
void addSlices(const test::SliceFolder& folder, const std::vector<Kind>& kinds) {
    const int count = int(kinds.size());
    folder.addStack(kPlaces * count, {}, "", [&](int k, SliceFile& slice) {
        slice.position.z = 2.0 * (k / count);
        slice.raw.assign(12, std::uint16_t(100 * (k % count)));
        slice.change = kinds[std::size_t(k % count)];
    });
}

/// Writes the same as frames of one file.
void addFrames(const test::SliceFolder& folder, const std::vector<Kind>& kinds) {
    test::EnhancedFile file;
    for (int place = 0; place < kPlaces; ++place)
        for (std::size_t kind = 0; kind < kinds.size(); ++kind)
            file.frames.push_back({.position = {0, 0, 2.0 * place},
                                   .intercept = 0,
                                   .raw = std::vector<std::uint16_t>(16 * 12, std::uint16_t(100 * kind)),
                                   .change = kinds[kind]});
    test::writeEnhancedFile(folder.path() / "frames", file);
}

/// Fails unless the folder holds one whole stack of each kind, in that order, under these names.
void verifyPhases(const test::SliceFolder& folder, const QStringList& names) {
    const ScanResult scan = folder.scan();
    QCOMPARE(int(scan.series.size()), int(names.size()));
    QCOMPARE(loadable(scan), int(names.size()));
    for (int phase = 0; phase < int(names.size()); ++phase) {
        const Series& series = scan.series[std::size_t(phase)];
        QCOMPARE(QString::fromStdString(series.series.phase), names[phase]);
        QCOMPARE(series.series.part, phase + 1);
        QCOMPARE(series.geometry.size.z, kPlaces);
        const auto volume = loadSeries(series, Padding::keep, noProgress);
        QVERIFY(volume && volume->lowestHu() == 100 * phase && volume->highestHu() == 100 * phase);
    }
}

}  // namespace

class PhasesTest : public QObject {
    Q_OBJECT

  private slots:
    void phasesAreEntriesOfTheirOwn_data() {
        QTest::addColumn<DcmTagKey>("tag");
        QTest::addColumn<QStringList>("values");
        QTest::addColumn<QStringList>("names");
        QTest::newRow("heart") << DcmTagKey(DCM_NominalPercentageOfCardiacPhase) << QStringList{"5", "40", "100"}
                               << QStringList{"5 % of the heartbeat", "40 % of the heartbeat",
                                              "100 % of the heartbeat"};
        QTest::newRow("trigger") << DcmTagKey(DCM_TriggerTime) << QStringList{"90", "350.5"}
                                 << QStringList{"90 ms after the heartbeat", "350.5 ms after the heartbeat"};
        QTest::newRow("energies") << DcmTagKey(DCM_KVP) << QStringList{"80", "140"}
                                  << QStringList{"X-rays of 80 kV", "X-rays of 140 kV"};
        QTest::newRow("acquisitions") << DcmTagKey(DCM_AcquisitionNumber) << QStringList{"2", "10"}
                                      << QStringList{"acquisition 2", "acquisition 10"};
        QTest::newRow("times") << DcmTagKey(DCM_AcquisitionTime) << QStringList{"101530.25", "101612"}
                               << QStringList{"taken at 10:15:30.25", "taken at 10:16:12"};
        QTest::newRow("echoes") << DcmTagKey(DCM_EchoTime) << QStringList{"4.92", "30", "102.0"}
                                << QStringList{"TE 4.92 ms", "TE 30 ms", "TE 102 ms"};
        QTest::newRow("numbered echoes") << DcmTagKey(DCM_EchoNumbers) << QStringList{"2", "10"}
                                         << QStringList{"echo 2", "echo 10"};
    }
    void phasesAreEntriesOfTheirOwn() {
        QFETCH(DcmTagKey, tag);
        QFETCH(QStringList, values);
        QFETCH(QStringList, names);
        std::vector<std::string> texts;
        for (const QString& value : values)
            texts.push_back(value.toStdString());
        std::vector<Kind> kinds;
        for (const std::string& text : texts)
            kinds.push_back(stating(tag, text.c_str()));
        const test::SliceFolder folder;
        addSlices(folder, kinds);
        verifyPhases(folder, names);
    }

    /// An image without a gradient has no direction, and the mean of all directions has none. Files and frames say it
    /// in different places.
    void diffusionIsToldApartByValueAndDirection() {
        const QStringList names{"b 0", "b 50", "b 1000", "b 1000 along 0 -0.71 0.71", "b 1000 along 1 0 0"};
        for (const bool inGroups : {false, true}) {
            const test::SliceFolder folder;
            (inGroups ? addFrames : addSlices)(
                folder, {diffusion(0, {1, 0, 0}, inGroups), diffusion(50, {}, inGroups), diffusion(1000, {}, inGroups),
                         diffusion(1000, {-0.0001, -0.7071, 0.7071}, inGroups), diffusion(1000, {1, 0, 0}, inGroups)});
            verifyPhases(folder, names);
        }
    }

    /// Echoes at several points in time: neither alone tells the images of a place apart.
    void echoesOverTimeAreApart() {
        const test::SliceFolder folder;
        std::vector<Kind> kinds;
        for (const char* echo : {"30", "80"})
            for (const char* time : {"1", "2"})
                kinds.push_back([=](DcmItem& item) {
                    item.putAndInsertString(DCM_EchoTime, echo);
                    item.putAndInsertString(DCM_TemporalPositionIdentifier, time);
                });
        addSlices(folder, kinds);
        verifyPhases(folder, {"TE 30 ms, point in time 1", "TE 30 ms, point in time 2", "TE 80 ms, point in time 1",
                              "TE 80 ms, point in time 2"});
    }

    /// A phase is judged for itself. What no value tells apart stays one refused entry.
    void onlyWholePhasesAreSplit() {
        const auto scanned = [](const std::function<bool(int)>& isThere, const std::function<const char*(int)>& value) {
            test::SliceFolder folder;
            folder.addStack(16, {.size = {4, 3}}, "", [&](int k, SliceFile& slice) {
                slice.position.z = 2.0 * (k / 2);
                slice.raw.assign(12, std::uint16_t(k % 2));
                slice.change = [&, k](DcmDataset& data) { data.putAndInsertString(DCM_AcquisitionNumber, value(k)); };
            });
            for (int k = 0; k < 16; ++k)
                if (!isThere(k))
                    std::filesystem::remove(folder.path() / (QString("%1").arg(k, 2, 10, QChar('0')).toStdString()));
            return folder.scan();
        };
        const auto oneOrTwo = [](int k) { return k % 2 ? "2" : "1"; };
        const ScanResult hole = scanned([](int k) { return k != 6; }, oneOrTwo);
        QCOMPARE(loadable(hole), 2);
        QCOMPARE(hole.series.size(), std::size_t(3));
        QVERIFY(!hole.series[0].series.resampled && hole.series[1].series.resampled);
        QCOMPARE(hole.series[2].verdict.stack, Stack::gap);
        QCOMPARE(loadable(scanned([](int k) { return k != 14; }, oneOrTwo)), 2);
        for (const auto& value : {std::function<const char*(int)>([](int) { return "1"; }),
                                  std::function<const char*(int)>([](int k) { return k < 4 ? "1" : "2"; })}) {
            const ScanResult doubled = scanned([](int) { return true; }, value);
            QCOMPARE(doubled.series.size(), std::size_t(1));
            QCOMPARE(doubled.series[0].verdict.stack, Stack::doubled);
            QVERIFY(doubled.series[0].series.phase.empty());
        }
    }

    void framesOfSeveralTimesStacksOrEchoesAreApart() {
        const auto inContent = [](const char* stack, Uint32 time) {
            return [=](DcmItem& own) {
                DcmItem& content = test::itemIn(own, DCM_FrameContentSequence);
                content.putAndInsertString(DCM_StackID, stack);
                content.putAndInsertUint32(DCM_TemporalPositionIndex, time);
            };
        };
        const auto echo = [](double time) {
            return [=](DcmItem& own) {
                test::itemIn(own, DCM_MREchoSequence).putAndInsertFloat64(DCM_EffectiveEchoTime, time);
            };
        };
        const std::vector<std::pair<std::vector<Kind>, QStringList>> cases{
            {{inContent("1", 1), inContent("1", 2)}, {"point in time 1", "point in time 2"}},
            {{inContent("A", 1), inContent("B", 1)}, {"stack A", "stack B"}},
            {{inContent("A", 1), inContent("A", 2), inContent("B", 1), inContent("B", 2)},
             {"stack A, point in time 1", "stack A, point in time 2", "stack B, point in time 1",
              "stack B, point in time 2"}},
            {{echo(2.46), echo(4.92)}, {"TE 2.46 ms", "TE 4.92 ms"}}};
        for (const auto& [kinds, names] : cases) {
            const test::SliceFolder folder;
            addFrames(folder, kinds);
            verifyPhases(folder, names);
        }
    }

    /// What tells phases apart may be left unassigned, and the rescale may be shared.
    void legacyConvertedFramesAreApart() {
        test::EnhancedFile file;
        for (int k = 0; k < 6; ++k) {
            test::EnhancedFrame frame{.position = {0, 0, 2.0 * (k % 3)}};
            frame.raw.assign(16 * 12, std::uint16_t(100 + k));
            frame.change = [k](DcmItem& own) {
                own.findAndDeleteElement(DCM_PixelValueTransformationSequence);
                own.findAndDeleteElement(DCM_FrameContentSequence);
                test::itemIn(own, DCM_UnassignedPerFrameConvertedAttributesSequence)
                    .putAndInsertString(DCM_AcquisitionNumber, k < 3 ? "3" : "4");
            };
            file.frames.push_back(frame);
        }
        file.change = [](DcmDataset& data) {
            DcmItem& shared = test::itemIn(data, DCM_SharedFunctionalGroupsSequence);
            DcmItem& rescale = test::itemIn(shared, DCM_PixelValueTransformationSequence);
            rescale.putAndInsertString(DCM_RescaleSlope, "1");
            rescale.putAndInsertString(DCM_RescaleIntercept, "-1000");
        };
        const test::SliceFolder folder;
        test::writeEnhancedFile(folder.path() / "frames", file);
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(2));
        QCOMPARE(std::string(scan.series[1].series.phase), std::string("acquisition 4"));
        const auto volume = loadSeries(scan.series[1], Padding::keep, noProgress);
        QVERIFY(volume);
        QCOMPARE(int(volume->voxels().front()), 103 - 1000);
        QCOMPARE(int(volume->voxels().back()), 105 - 1000);
    }
};

QTEST_GUILESS_MAIN(PhasesTest)
#include "phases_test.moc"
