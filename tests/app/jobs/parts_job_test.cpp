/// Parts of a scan in the background: read and found, joined, asked about, and refused with a reason.

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/jobs/parts_job.h"
#include "render/volume/file/label_nrrd.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/scenes/vessel_phantoms.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

std::shared_ptr<const Volume> aorta() {
    static const auto scan = std::make_shared<const Volume>(test::scanOf(test::aortaBesideSpine()));
    return scan;
}

/// A map on `grid` with a part of its first voxels.
LabelMap someLabels(const VolumeGeometry& grid, std::vector<MappedPart> parts = {{"liver", {40, 200, 40}}}) {
    LabelMap map;
    map.geometry = grid;
    map.labels.assign(grid.voxelCount(), 0);
    for (std::size_t i = 0; i < 500; ++i)
        map.labels[i] = std::uint8_t(1 + i * parts.size() / 500);
    map.parts = std::move(parts);
    return map;
}

/// A job, and what it has said.
struct Work {
    PartsJob job;
    PartSources sources;
    std::shared_ptr<const ScanParts> parts;
    QSignalSpy added{&job, &PartsJob::added}, made{&job, &PartsJob::made}, failed{&job, &PartsJob::failed},
        asked{&job, &PartsJob::resamplingWanted}, missing{&job, &PartsJob::labelsMissing};

    Work() {
        const auto take = [this](const PartSources& from, const std::shared_ptr<const ScanParts>& found) {
            sources = from;
            parts = found;
        };
        QObject::connect(&job, &PartsJob::added, take);
        QObject::connect(&job, &PartsJob::made, take);
    }
    void wait() { QTRY_VERIFY_WITH_TIMEOUT(!job.isRunning(), test::kPatience); }
    QString error() const { return QString::fromStdString(failed.last()[0].value<Error>().text()); }
};

}  // namespace

class PartsJobTest : public QObject {
    Q_OBJECT

  private slots:
    void partsOfAllSourcesAreJoined() {
        Work work;
        const PartsJob::Scan scan{aorta(), {}};
        work.job.open(scan, write(someLabels(aorta()->geometry())), Resampling::refused, {});
        work.wait();
        QVERIFY2(work.added.size() == 1, work.failed.isEmpty() ? "" : qPrintable(work.error()));
        QCOMPARE(work.sources.labels, labelsHash(*work.parts->map));
        QVERIFY(!work.parts->facts[0].byRule && work.parts->facts[0].ml > 0.4);
        work.job.find(scan, PartRule::vessels, work.sources);
        work.wait();
        const LabelMap& map = *work.parts->map;
        QCOMPARE(map.parts.size(), std::size_t(2));
        QVERIFY(map.parts[0].name == "liver" && map.parts[1].name == "vessels" && work.parts->facts[1].byRule);
        QCOMPARE(work.parts->facts[1].ml, partsMl(map)[1]);
        QVERIFY(!map.notes.empty());
        QVERIFY(work.sources == (PartSources{work.sources.labels, kVesselsRule, 0}) && !work.sources.labels.empty());
    }

    /// Undo and plans want parts by their sources alone.
    void partsAreMadeAgain() {
        Work work;
        const PartsJob::Scan scan{aorta(), {}};
        work.job.make(scan, {.vessels = kVesselsRule});
        work.wait();
        QVERIFY(work.made.size() == 1 && work.parts->map->parts[0].name == "vessels");
        const std::shared_ptr<const LabelMap> found = work.parts->map;
        work.job.make(scan, {.vessels = kVesselsRule, .shells = kShellsRule});
        work.wait();
        QVERIFY(work.made.size() == 2 && work.parts->map->parts.size() == 3);
        work.job.make(scan, {.vessels = kVesselsRule});
        work.wait();
        QVERIFY(work.parts->map == found);  // it was not searched for again
        work.job.make(scan, {.labels = "0123", .vessels = kVesselsRule});
        work.wait();
        QVERIFY(work.missing.size() == 1 && work.made.size() == 3);
    }

    /// Every move of the camera asks for parts that are not there yet.
    void whatIsBeingMadeGoesOn() {
        Work work;
        constexpr double kLate = 0.6;
        bool isLate = false;
        QObject::connect(&work.job, &PartsJob::progressed, [&](double fraction, const QString&) {
            QVERIFY2(!isLate || fraction >= kLate, "it has begun again");
            if (!isLate && fraction >= kLate) {
                isLate = true;
                work.job.make({aorta(), {}}, {.vessels = kVesselsRule});
            }
        });
        work.job.make({aorta(), {}}, {.vessels = kVesselsRule});
        work.wait();
        QVERIFY(work.made.size() == 1);
    }

    void anotherGridIsAskedAbout() {
        Work work;
        const PartsJob::Scan scan{aorta(), {}};
        const VolumeGeometry coarse = VolumeGeometry::aligned({80, 60, 36}, {1.7, 1.7, 2.8}, {-67.2, -50.2, 0.7});
        const QString file = write(someLabels(coarse));
        work.job.open(scan, file, Resampling::refused, {});
        work.wait();
        QVERIFY(work.asked.size() == 1 && work.asked[0][0].toString() == file && work.added.isEmpty());
        const QString what = QString::fromStdString(work.asked[0][1].value<Error>().what);
        QVERIFY2(what.contains("1.7 x 1.7 x 2.8 mm") && what.contains("0.85 x 0.85 x 1.4 mm"), qPrintable(what));
        work.job.open(scan, file, Resampling::nearest, {});
        work.wait();
        QVERIFY(work.added.size() == 1 && work.parts->map->geometry.size == aorta()->geometry().size);
        QVERIFY(work.parts->map->notes.back().find("resampled") != std::string::npos);
    }

    void whatDoesNotBelongIsRefused() {
        const VolumeGeometry& grid = aorta()->geometry();
        VolumeGeometry shifted = grid, elsewhere = grid;
        shifted.patientFromIndex[3].x += 0.425;
        elsewhere.patientFromIndex[3].z += 300;
        LabelMap mirrored = someLabels(grid, {{"kidney_left", {}}, {"kidney_right", {}}});
        for (std::size_t i = 0; i < mirrored.labels.size(); ++i)
            mirrored.labels[i] = std::uint8_t(int(i) % grid.size.x < 20 ? 1 : int(i) % grid.size.x > 140 ? 2 : 0);
        for (const auto& [map, reason] :
             {std::pair(someLabels(shifted), "shifted"), std::pair(someLabels(elsewhere), "another scan or patient"),
              std::pair(mirrored, "\"kidney_left\" lies at the right of \"kidney_right\"")}) {
            Work work;
            const QString file = write(map);
            work.job.open({aorta(), {}}, file, Resampling::refused, {});
            work.wait();
            QVERIFY2(work.failed.size() == 1 && work.added.isEmpty() && work.asked.isEmpty(), reason);
            QVERIFY2(work.error().contains(reason) && work.error().contains(file), qPrintable(work.error()));
        }
    }

    void noFileAndNoContrastAreSaid() {
        Work work;
        const auto plain = test::makeVolume({40, 40, 20}, dvec3(2), [](int i, int, int) { return i < 30 ? 40 : -900; });
        work.job.find({plain, {}}, PartRule::vessels, {});
        work.wait();
        QVERIFY2(work.failed.size() == 1 && work.error().contains("no contrast medium"), qPrintable(work.error()));
        work.job.open({plain, {}}, folder_.filePath("none.nrrd"), Resampling::refused, {});
        work.wait();
        QVERIFY2(work.failed.size() == 2 && work.error().contains("none.nrrd"), qPrintable(work.error()));
    }

    void aFileThatIsRefusedLeavesTheOneBefore() {
        Work work;
        const PartsJob::Scan scan{aorta(), {}};
        work.job.open(scan, write(someLabels(aorta()->geometry())), Resampling::refused, {});
        work.wait();
        const PartSources before = work.sources;
        std::vector<MappedPart> many(LabelMap::kMostParts, MappedPart{"x", {}});
        LabelMap full = someLabels(aorta()->geometry());
        full.parts = many;
        for (std::size_t i = 0; i < many.size(); ++i) {
            full.parts[i].name += std::to_string(i);
            full.labels[i] = std::uint8_t(i + 1);
        }
        work.job.open(scan, write(full), Resampling::refused, {.vessels = kVesselsRule});
        work.wait();
        QVERIFY2(work.failed.size() == 1, "256 parts were taken");
        work.job.make(scan, before);
        work.wait();
        QVERIFY(work.made.size() == 1 && work.missing.isEmpty());
    }

    void aClosedScanIsReleased() {
        Work work;
        auto scan = std::make_shared<const Volume>(*aorta());
        const std::weak_ptr<const Volume> held = scan;
        work.job.find({scan, {}}, PartRule::vessels, {});
        scan.reset();
        work.job.forget();
        QTRY_VERIFY_WITH_TIMEOUT(held.expired(), test::kPatience);
        QVERIFY(work.added.isEmpty());
    }

  private:
    /// Writes a map to a file of its own, and returns its path.
    QString write(const LabelMap& map) {
        const QString file = folder_.filePath(QString("labels%1.seg.nrrd").arg(++files_));
        const auto written = writeLabelFile(map, ui::fromQt(file));
        if (!written)
            qFatal("%s", written.error().text().c_str());
        return file;
    }

    QTemporaryDir folder_;
    int files_ = 0;
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::PartsJobTest)
#include "parts_job_test.moc"
