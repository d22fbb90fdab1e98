/// Plans as files: they come back as they were, refuse what is wrong, and belong to one scan.

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "app/plan/plan_fields.h"
#include "app/plan/plan_file.h"
#include "app/plan/scan_fit.h"
#include "tests/support/random_fields.h"
#include "tests/support/scenes/scenes.h"

namespace pdr::app {
namespace {

/// Returns a plan with random values in all its fields.
SavedPlan anyPlan(test::RandomFields& random) {
    for (;;) {
        SavedPlan saved;
        describe(random, saved.plan);
        ImageSetup& image = saved.plan.image;
        std::ranges::sort(image.look.transferFunction.nodes, {}, &TransferNode::hu);
        if (image.look.window.lowHu > image.look.window.highHu)
            std::swap(image.look.window.lowHu, image.look.window.highHu);
        if (!check(image))
            continue;
        std::uint64_t id = 0;
        for (Measurement& measurement : saved.plan.measurements) {
            measurement.id = ++id;
            measurement.places.resize(placesOf(measurement.kind));
            for (measure::Place& place : measurement.places)
                for (dmat3& share : place.spread.mm2) {
                    const dvec3 one(share[0][0], share[0][1], share[0][2]);
                    share = glm::outerProduct(one / 1e7, one / 1e7) + dmat3(glm::length(one) / 1e9);
                    share = 0.5 * (share + glm::transpose(share));
                }
        }
        saved.scan = {newSalt(), std::string(64, 'a'), std::string(80, 'b'), {3, 4, 5}, {0.5, 0.25, 2}, 1};
        return saved;
    }
}

std::shared_ptr<const Volume> scan(int hu = 40) {
    return test::makeVolume({6, 5, 4}, dvec3(1, 1, 2), [hu](int i, int j, int k) { return hu + i + 10 * j + 100 * k; });
}

SavedPlan smallPlan() {
    SavedPlan saved;
    saved.plan.image.look.transferFunction.nodes = {{0, 0}};
    saved.plan.measurements = {{17, MeasureKind::distance, "defect", {measure::typedPlace({1, 2, 3}), {}}}};
    saved.scan = markOf(*scan(), newSalt());
    return saved;
}

/// Returns the text of a plan with every `from` replaced by `to`.
std::string changed(const SavedPlan& saved, const QString& from, const QString& to) {
    QString text = QString::fromStdString(planText(saved));
    if (!text.contains(from))
        qFatal("the plan has no '%s'", qPrintable(from));
    return text.replace(from, to).toStdString();
}

}  // namespace

class PlanFileTest : public QObject {
    Q_OBJECT

  private slots:
    void anyPlanComesBackToTheBit() {
        test::RandomFields random(1);
        std::size_t measurements = 0, cuts = 0;
        std::set<MeasureKind> kinds;
        for (int i = 0; i < 1000; ++i) {
            const SavedPlan saved = anyPlan(random);
            const Result<SavedPlan> read = planFromText(planText(saved), "a test");
            QVERIFY2(read, read ? "" : read.error().text().c_str());
            QVERIFY2(*read == saved, planText(saved).c_str());
            measurements += saved.plan.measurements.size();
            for (const Measurement& measurement : saved.plan.measurements)
                kinds.insert(measurement.kind);
            cuts += saved.plan.image.clip.box.has_value();
        }
        QVERIFY(measurements > 500 && cuts > 50);
        QCOMPARE(kinds.size(), kMeasureKinds);
    }

    void everyMistakeNamesItsField() {
        const auto where = [](const std::string& text) {
            const auto read = planFromText(text, "p");
            return read ? std::string("nowhere") : read.error().where;
        };
        const SavedPlan saved = smallPlan();
        QCOMPARE(where(planText(saved)), std::string("nowhere"));
        QCOMPARE(where(changed(saved, "\"kind\": \"distance\"", "\"kind\": \"angle\"")),
                 std::string("p, measurements[0].places"));
        QCOMPARE(where(changed(saved, "\"kind\": \"distance\"", "\"kind\": \"point\"")),
                 std::string("p, measurements[0].places"));
        QCOMPARE(where(changed(saved, "\"kind\": \"distance\"", "\"kind\": \"ball\"")), std::string("nowhere"));
        QCOMPARE(where(changed(saved, "\"kind\": \"distance\"", "\"kind\": \"ellipse\"")),
                 std::string("p, measurements[0].places"));
        QCOMPARE(where(changed(saved, "\"kind\": \"distance\"", "\"kind\": \"length\"")),
                 std::string("p, measurements[0].kind"));
        QCOMPARE(where(changed(saved, "\"name\": \"defect\"", "\"patient\": \"defect\"")),
                 std::string("p, measurements[0].patient"));
        QCOMPARE(where(changed(saved, "\"version\": 1", "\"version\": 2")), std::string("p, version"));
        QCOMPARE(where(changed(saved, "\"importRule\": 1", "\"importRule\": 0")), std::string("p, scan.importRule"));
        QCOMPARE(where(changed(saved, "\"widthHu\": 350.0", "\"widthHu\": 0")),
                 std::string("p, navigation.window.widthHu"));
        SavedPlan corners = saved;
        corners.plan.measurements[0].kind = MeasureKind::polygon;
        for (const std::size_t count : {std::size_t(2), kMostCorners + 1, std::size_t(3), kMostCorners}) {
            corners.plan.measurements[0].places.resize(count);
            const bool fits = count >= 3 && count <= kMostCorners;
            QCOMPARE(where(planText(corners)), std::string(fits ? "nowhere" : "p, measurements[0].places"));
        }
        SavedPlan twice = saved;
        twice.plan.measurements.push_back(twice.plan.measurements[0]);
        QCOMPARE(where(planText(twice)), std::string("p, measurements[1].id"));
        SavedPlan unsure = saved;
        unsure.plan.measurements[0].places[1].spread.of(measure::Cause::hand) = dmat3(1, 5, 0, 5, 1, 0, 0, 0, 1);
        QCOMPARE(where(planText(unsure)), std::string("p, measurements[0].places[1]"));
    }

    /// Cut off or changed anywhere, a file is refused with a sentence, or read as some plan: never a crash.
    void damagedFilesAreRefused() {
        const std::string whole = planText(smallPlan());
        std::size_t refused = 0;
        for (std::size_t length = 0; length < whole.size() - 2; length += 7)
            refused += !planFromText(whole.substr(0, length), "p");
        QCOMPARE(refused, (whole.size() - 2 + 6) / 7);
        for (std::size_t at = 0; at < whole.size(); ++at)
            for (const char other : {'}', '"', '9', '\0', '\xff'}) {
                std::string damaged = whole;
                damaged[at] = other;
                if (const auto read = planFromText(damaged, "p"); !read)
                    QVERIFY(!read.error().what.empty());
            }
    }

    /// A place seen through fog is far less sure along the ray than across it: still a covariance, whatever rounds.
    void placesAsUnsureAsCanBeComeBack() {
        std::mt19937_64 random(5);
        std::normal_distribution<double> normal;
        SavedPlan saved = smallPlan();
        for (int trial = 0; trial < 300; ++trial) {
            const dvec3 ray = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
            const double along = std::pow(10.0, normal(random)), across = trial % 2 * 0.05;
            const dmat3 spread = along * along * glm::outerProduct(ray, ray) +
                                 across * across * (dmat3(1) - glm::outerProduct(ray, ray));
            measure::Place& place = saved.plan.measurements[0].places[0];
            place.spread.of(measure::Cause::light) = 0.5 * (spread + glm::transpose(spread));
            const auto read = planFromText(planText(saved), "p");
            QVERIFY2(read, read ? "" : read.error().text().c_str());
            QVERIFY(*read == saved);
        }
    }

    /// One direction of negative variance, however the axes lie, is none that this program has written.
    void aNegativeVarianceIsRefused() {
        std::mt19937_64 random(6);
        std::normal_distribution<double> normal;
        SavedPlan saved = smallPlan();
        for (int trial = 0; trial < 100; ++trial) {
            const dvec3 a = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
            const dvec3 b = glm::normalize(glm::cross(a, dvec3(normal(random), normal(random), normal(random))));
            const dmat3 spread = 100.0 * glm::outerProduct(a, a) - 1e-3 * glm::outerProduct(b, b);
            measure::Place& place = saved.plan.measurements[0].places[0];
            place.spread.of(measure::Cause::light) = 0.5 * (spread + glm::transpose(spread));
            QVERIFY(!planFromText(planText(saved), "p"));
        }
    }

    void aScanIsKnownByItsVoxelsAndPlaces() {
        const ScanMark mark = markOf(*scan(), newSalt());
        QVERIFY(checkIsScanOf(mark, *scan()));
        const auto why = [&](const Volume& volume) {
            const auto ok = checkIsScanOf(mark, volume);
            return ok ? std::string("the same") : ok.error().text();
        };
        const std::shared_ptr<const Volume> same = scan();
        Voxels voxels(same->voxels().begin(), same->voxels().end());
        VolumeGeometry moved = scan()->geometry();
        moved.patientFromIndex[3].x += 0.01;
        QVERIFY(QString::fromStdString(why(Volume(moved, voxels))).contains("same voxels at another place"));
        moved.patientFromIndex[3].x += 1e-8 - 0.01;
        QCOMPARE(why(Volume(moved, voxels)), std::string("the same"));
        const auto larger = test::makeVolume({6, 5, 5}, dvec3(1, 1, 2), [](int, int, int) { return 0; });
        QVERIFY(QString::fromStdString(why(*larger)).contains("6 x 5 x 5"));
    }

    /// A scan of which a few slices were sent again is not taken for another patient's.
    void itSaysWhichSlicesDiffer_data() {
        QTest::addColumn<QList<int>>("changed");
        QTest::addColumn<bool>("older");
        QTest::addColumn<QString>("said");
        QTest::newRow("one") << QList<int>{3} << false << "the voxels of slice 4 are not";
        QTest::newRow("neighbours") << QList<int>{1, 2} << false << "the voxels of slices 2 to 3 are not";
        QTest::newRow("some") << QList<int>{0, 1, 3} << false << "the voxels of 3 slices between 1 and 4 are not";
        QTest::newRow("all") << QList<int>{0, 1, 2, 3} << false << "has the size of the plan's, but other voxels";
        QTest::newRow("older plan") << QList<int>{3} << true << "has the size of the plan's, but other voxels";
    }
    void itSaysWhichSlicesDiffer() {
        QFETCH(const QList<int>, changed);
        QFETCH(const bool, older);
        QFETCH(const QString, said);
        ScanMark mark = markOf(*scan(), newSalt());
        if (older)
            mark.sliceHashes.clear();
        const std::shared_ptr<const Volume> same = scan();
        Voxels voxels(same->voxels().begin(), same->voxels().end());
        for (const int k : changed)
            voxels[std::size_t(k) * 6 * 5] += 1;
        const auto ok = checkIsScanOf(mark, Volume(same->geometry(), voxels));
        QVERIFY(!ok && ok.error().kind == ErrorKind::refused);
        QVERIFY2(QString::fromStdString(ok.error().text()).contains(said), ok.error().text().c_str());
    }

    /// Nothing is measured where nothing was scanned; but a region's border may lie there.
    void placesOutsideTheScanAreRefused() {
        SavedPlan saved = smallPlan();
        const auto said = [&] {
            const auto ok = checkPlaces(saved.plan, scan()->geometry());
            return ok ? std::string() : ok.error().text();
        };
        std::vector<measure::Place>& places = saved.plan.measurements[0].places;
        const dvec3 face = scan()->geometry().centreMm() + dvec3(3, 0, 0);  // of the last voxel
        places[1].mm = face;
        QCOMPARE(said(), std::string());
        places[1].mm = face + dvec3(40, 0, 0);
        QVERIFY2(said().starts_with("measurements[0].places[1].mm lies 40 mm outside the scan"), said().c_str());
        saved.plan.measurements[0].kind = MeasureKind::ball;
        QCOMPARE(said(), std::string());
        saved.plan.measurements[0].kind = MeasureKind::ellipse;
        QCOMPARE(said(), std::string());
        std::swap(places[0], places[1]);
        QVERIFY(!said().empty());
    }

    /// Plans would get lost if this changed unnoticed: a change of voxels or of their hash needs another kImportRule.
    void theHashOfAScanStaysTheSame() {
        QCOMPARE(markOf(*scan(), std::string(32, '0')).hash, std::string(kGoldenHash));
    }

    /// Nobody finds two plans of one patient by comparing files.
    void twoPlansOfOneScanHaveNothingInCommon() {
        const ScanMark first = markOf(*scan(), newSalt()), second = markOf(*scan(), newSalt());
        QVERIFY(first.salt != second.salt && first.hash != second.hash);
    }

    void aFileIsTheOwnersAndWholeOrNotThere() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("head.plan.json").toStdString();
        const SavedPlan saved = smallPlan();
        QVERIFY(writePlan(saved, file));
        const auto rights = QFile(folder.filePath("head.plan.json")).permissions();
        QVERIFY(!(rights & (QFile::ReadGroup | QFile::ReadOther)));
        const auto read = readPlan(file);
        QVERIFY(read && *read == saved);
        QVERIFY(!writePlan(saved, folder.filePath("no/such/place.json").toStdString()));
        QVERIFY(!readPlan(folder.filePath("missing.json").toStdString()));
        QVERIFY(!readPlan("/dev/zero"));
    }

  private:
    static constexpr const char* kGoldenHash = "22ecb7defc0af1d0cbb7279c9d0da22b966eaf0b95b08e396edd796465bd0397";
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::PlanFileTest)
#include "plan_file_test.moc"
