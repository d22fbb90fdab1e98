/// What `pdrender-cli plan` says of a plan, what it writes, and what it refuses.

#include <sys/resource.h>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <csignal>

#include "app/plan/marks_csv.h"
#include "app/plan/marks_slicer.h"
#include "app/scan/scene_volume.h"
#include "render/volume/file/label_nrrd.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/program_run.h"
#include "tests/support/some_marks.h"

namespace pdr::app {
namespace {

using test::ProgramRun;

ProgramRun runPlan(const QStringList& arguments, const std::function<void(QProcess&)>& prepare = {}) {
    return test::runProgram("pdrender-cli", QStringList("plan") + arguments, prepare);
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class PlanCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::shared_ptr<const Volume> scan_;
    SavedPlan saved_;
    std::vector<MarkRow> rows_;

    QString at(const QString& name) const { return folder_.filePath(name); }
    QString series() const { return at("series"); }
    QString plan() const { return at("head.plan.json"); }
    static void compareRegion(const QJsonValue& region, const MarkRow& row) {
        QCOMPARE(region.isNull(), !row.value || !row.value->region);
        if (region.isNull())
            return;
        const measure::RegionStatistics& expected = *row.value->region;
        QCOMPARE(region["voxels"].toInt(), int(expected.count));
        QCOMPARE(region["millilitres"].toDouble(), expected.millilitres);
        QCOMPARE(region["meanHu"].toDouble(), expected.meanHu);
        QCOMPARE(region["meanPlusMinus95"].toDouble(-1), expected.meanPlusMinus.value_or(-1));
        QCOMPARE(region["sdHu"].toDouble(), expected.sdHu);
        QCOMPARE(region["medianHu"].toDouble(), expected.medianHu);
        QCOMPARE(region["lowestHu"].toDouble(), expected.lowestHu);
        QCOMPARE(region["highestHu"].toDouble(), expected.highestHu);
    }
    static void compareArea(const QJsonValue& area, const MarkRow& row) {
        const bool isFlat = row.kind == MeasureKind::ellipse || row.kind == MeasureKind::polygon;
        QCOMPARE(area.isNull(), !isFlat);
        if (area.isNull())
            return;
        const measure::Stated& expected = *row.value->area;
        QCOMPARE(area["mm2"].toDouble(), expected.value);
        QCOMPARE(area["plusMinus95"].toDouble(-1), plusMinusOf(expected).value_or(-1));
        QCOMPARE(area["bound"].toString().toStdString(), std::string(boundWord(expected.bound)));
    }
    void save(const SavedPlan& saved, const QString& file) const { QVERIFY(writePlan(saved, file.toStdString())); }

  private slots:
    void initTestCase() {
        const auto written = writePhantomSeries(series().toStdString());
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        VolumeSource source;
        source.dicomFolder = series().toStdString();
        source.table = Table::hidden;
        const auto fetched = fetchVolume(source, noProgress);
        QVERIFY(fetched);
        scan_ = fetched->wanted.volume;
        saved_ = {markOf(*scan_, newSalt()), test::someMarks()};
        saved_.plan.image.camera.eyeMm = scan_->geometry().centreMm() - dvec3(0, 400, 0);
        saved_.plan.image.camera.targetMm = scan_->geometry().centreMm();
        save(saved_, plan());
        rows_ = marksTable(saved_.plan, *scan_);
    }

    void theValuesAreThoseOfTheWindow() {
        const ProgramRun run = runPlan({plan(), "--scan", series(), "--json"});
        QVERIFY2(run.code == 0, run.err.constData());
        const QJsonDocument said = QJsonDocument::fromJson(run.out);
        QCOMPARE(said["format"].toString(), "pdrender-marks");
        QCOMPARE(said["version"].toInt(), 1);
        QVERIFY(said["scan"]["read"].toBool());
        const QJsonArray marks = said["marks"].toArray();
        QCOMPARE(marks.size(), qsizetype(rows_.size()));
        for (std::size_t n = 0; n < rows_.size(); ++n) {
            const MarkRow& row = rows_[n];
            const QJsonObject mark = marks[qsizetype(n)].toObject();
            QCOMPARE(mark["id"].toString().toULongLong(), row.id);
            QCOMPARE(mark["kind"].toString().toStdString(), std::string(kindWord(row.kind)));
            QCOMPARE(mark["name"].toString().toStdString(), row.name);
            QCOMPARE(mark["text"].toString().toStdString(), readable(row));
            QCOMPARE(mark["value"].isNull(), !row.value);
            QCOMPARE(mark["plusMinus95"].isNull(), !row.value || !row.value->plusMinus);
            if (row.value)
                QCOMPARE(mark["value"].toDouble(), row.value->value);
            if (row.value && row.value->plusMinus)
                QCOMPARE(mark["plusMinus95"].toDouble(), *row.value->plusMinus);
            compareRegion(mark["region"], row);
            compareArea(mark["area"], row);
            const QJsonArray places = mark["places"].toArray();
            QCOMPARE(places.size(), qsizetype(row.places.size()));
            for (qsizetype place = 0; place < places.size(); ++place)
                for (int axis = 0; axis < 3; ++axis)
                    QCOMPARE(places[place]["mm"][axis].toDouble(), row.places[std::size_t(place)].mm[axis]);
        }
    }

    void theTableIsForPeople() {
        const ProgramRun run = runPlan({plan(), "--scan", series()});
        QCOMPARE(run.code, 0);
        for (const MarkRow& row : rows_)
            QVERIFY2(run.out.contains(readable(row).c_str()), run.out.constData());
        QVERIFY2(run.out.contains("Distance 1") && run.out.contains("aorta"), run.out.constData());
        QVERIFY2(run.out.contains("-13.25  -20.00"), run.out.constData());
        QVERIFY(!run.err.contains("note: the scan was not read"));
    }

    /// A plan alone says what does not depend on its scan.
    void withoutTheScanItSaysWhatIsNotKnown() {
        const ProgramRun run = runPlan({plan()});
        QCOMPARE(run.code, 0);
        QVERIFY2(run.err.contains("note: the scan was not read"), run.err.constData());
        QVERIFY2(run.out.contains("5.0 mm") && run.out.contains("not known without the scan"), run.out.constData());
        const QJsonDocument said = QJsonDocument::fromJson(runPlan({plan(), "--json"}).out);
        QVERIFY(!said["scan"]["read"].toBool());
        QCOMPARE(said["scan"]["size"][0].toInt(), scan_->size().x);
        QVERIFY(said["marks"][7]["value"].isNull());
    }

    void filesAreThoseOfTheTable() {
        const ProgramRun run = runPlan({plan(), "--scan", series(), "-o", at("a.csv"), "-o", at("a.mrk.json")});
        QVERIFY2(run.code == 0, run.err.constData());
        QCOMPARE(contents(at("a.csv")).toStdString(), marksCsv(rows_));
        QCOMPARE(contents(at("a.mrk.json")).toStdString(), marksForSlicer(rows_));
        QVERIFY(!(QFile::permissions(at("a.csv")) & (QFile::ReadGroup | QFile::ReadOther)));
        QVERIFY(run.out.contains(at("a.csv").toUtf8()));
    }

    void nobodyIsGivenAway() {
        const ProgramRun run = runPlan({plan(), "--scan", series(), "--json"});
        for (const QByteArray& text : {run.out, contents(at("a.csv")), contents(at("a.mrk.json"))})
            for (const char* canary : {"Phantom", "PHANTOM", "Head", "1.2.826", "series", "/tmp"})
                QVERIFY2(!text.isEmpty() && !text.contains(canary), canary);
    }

    void anotherScanIsRefusedAndNothingIsWritten() {
        const QString other = at("other");
        const Volume head = headPhantom({64, 57, 63}, {3.9, 4.9, 3.9});
        QVERIFY(dicom::writeSeries(head, {"Two", "TWO", "Test", "Two", "Made."}, other.toStdString(), noProgress));
        const ProgramRun run = runPlan({plan(), "--scan", other, "-o", at("other.csv")});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("this is another scan: 64 x 57 x 63 voxels"), run.err.constData());
        QVERIFY(run.out.isEmpty() && !QFile::exists(at("other.csv")));
        SavedPlan changed = saved_;
        changed.scan.hash[0] = changed.scan.hash[0] == '0' ? '1' : '0';
        save(changed, at("changed.plan.json"));
        const ProgramRun voxels = runPlan({at("changed.plan.json"), "--scan", series()});
        QCOMPARE(voxels.code, 1);
        QVERIFY2(voxels.err.contains("same voxels at another place"), voxels.err.constData());
    }

    /// The plan is at fault, not the scan: it is named, and what to do about it.
    void aPlaceOutsideTheScanIsThePlansFault() {
        SavedPlan outside = saved_;
        outside.plan.measurements[0].places[0].mm.x += 5000;
        save(outside, at("outside.plan.json"));
        const ProgramRun run = runPlan({at("outside.plan.json"), "--scan", series()});
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("outside.plan.json: measurements[0].places[0].mm lies"), run.err.constData());
        QVERIFY2(run.err.contains("Correct that place"), run.err.constData());
    }

    /// With --json, the measurements alone are on standard output.
    void whatThePlanShowsIsRendered() {
        const QStringList command{plan(),      "--scan", series(),  "--render",  "-o",
                                  at("a.png"), "--size", "140x130", "--samples", "2"};
        const ProgramRun run = runPlan(command + QStringList{"--json", "--annotations", "none"});
        QVERIFY2(run.code == 0, run.err.constData());
        const QImage bare(at("a.png"));
        QCOMPARE(bare.size(), QSize(140, 130));
        QVERIFY2(!QJsonDocument::fromJson(run.out).isNull(), run.out.constData());
        QVERIFY2(run.err.contains("a.png"), run.err.constData());
        const ProgramRun letters = runPlan(command);
        QVERIFY2(letters.code == 0 && letters.out.contains("a.png"), letters.err.constData());
        QVERIFY(QImage(at("a.png")).size() == bare.size() && QImage(at("a.png")) != bare);
    }

    void aPlanWithADenoisedCtIsRenderedSo() {
        SavedPlan saved = saved_;
        saved.plan.image.look.ctDenoised = true;
        save(saved, at("quiet.plan.json"));
        const ProgramRun run = runPlan({at("quiet.plan.json"), "--scan", series(), "--render", "-o", at("quiet.png"),
                                        "--size", "40x30", "--samples", "1"});
        QVERIFY2(run.code == 0, run.err.constData());
        QVERIFY(QImage(at("quiet.png")).text("pdrender/remarks").contains("CT denoised"));
    }

    /// An image without the parts would be another one. That with them is the window's: same_image_test.
    void aPlanWithoutItsPartsIsNotRendered() {
        LabelMap map;
        map.geometry = scan_->geometry();
        map.labels.assign(map.geometry.voxelCount(), 1);
        map.parts = {{"liver", {40, 200, 40}}};
        QVERIFY(bool(writeLabelFile(map, at("other.seg.nrrd").toStdString())));
        SavedPlan saved = saved_;
        saved.plan.image.look.parts.rest = PartState::hidden;
        const auto refusal = [&](const PartSources& sources, const QStringList& options) {
            saved.plan.partSources = sources;
            save(saved, at("parts.plan.json"));
            const QStringList listed{at("parts.plan.json"), "--scan", series()};
            const ProgramRun run = runPlan(listed + QStringList{"--render", "-o", at("parts.png")} + options);
            return runPlan(listed).code == 0 && run.code == 1 && !QFile::exists(at("parts.png")) ? run.err
                                                                                                 : "no refusal";
        };
        const PartSources ofMap{.labels = "0123456789abcdef0123456789abcdef"};
        const QStringList other{"--labels", at("other.seg.nrrd")};
        QVERIFY2(refusal(ofMap, {}).contains("holds neither the voxels nor the place"), refusal(ofMap, {}).constData());
        QVERIFY2(refusal(ofMap, other).contains("not the label map that the plan shows"),
                 refusal(ofMap, other).constData());
        QVERIFY2(refusal({}, other).contains("the plan shows no label map"), refusal({}, other).constData());
        const PartSources found{.vessels = kVesselsRule};
        QVERIFY2(refusal(found, {}).contains("vessels cannot be found"), refusal(found, {}).constData());
    }

    void foreignAndDamagedPlansAreRefused() {
        const QByteArray text = contents(plan());
        const auto said = [&](const QByteArray& content) {
            QFile file(at("damaged.json"));
            if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
                qFatal("the test cannot write its files");
            file.close();
            const ProgramRun run = runPlan({at("damaged.json"), "-o", at("damaged.csv")});
            return run.code == 1 && run.out.isEmpty() && !QFile::exists(at("damaged.csv")) ? run.err : "no refusal";
        };
        QVERIFY2(said("{}").contains("format"), said("{}").constData());
        QVERIFY(said("not JSON").contains("damaged.json"));
        QVERIFY(said(text.left(text.size() / 2)).contains("damaged.json"));
        QVERIFY(said(QByteArray(text).replace("\"distance\"", "\"length\"")).contains("measurements[0].kind"));
        QVERIFY(said(QByteArray(text).replace("\"version\": 1", "\"version\": 9")).contains("version"));
        QCOMPARE(runPlan({at("missing.json")}).code, 1);
    }

    /// A plan may come from anybody: its names must not move the cursor.
    void namesDoNotCommandTheTerminal() {
        SavedPlan saved = saved_;
        saved.plan.measurements = {{1, MeasureKind::point, "\x1b[2J\u202Ename\n", {measure::typedPlace({})}}};
        save(saved, at("named.plan.json"));
        const ProgramRun run = runPlan({at("named.plan.json")});
        QCOMPARE(run.code, 0);
        QVERIFY(!run.out.contains('\x1b') && !run.out.contains("\u202E") && run.out.contains("name"));
        QCOMPARE(run.out.count('\n'), 3);
    }

    void aFullDiskLeavesWhatWasThere() {
        const QByteArray before = contents(at("a.csv"));
        const ProgramRun run = runPlan({plan(), "-o", at("a.csv")}, [](QProcess& process) {
            process.setChildProcessModifier([] {
                const rlimit tiny{100, 100};  // files of at most so many bytes, for the child alone
                ::setrlimit(RLIMIT_FSIZE, &tiny);
                std::signal(SIGXFSZ, SIG_IGN);
            });
        });
        QCOMPARE(run.code, 1);
        QVERIFY2(run.err.contains("a.csv"), run.err.constData());
        QVERIFY(!before.isEmpty() && contents(at("a.csv")) == before);
    }

    void thePlanItselfIsNotOverwritten() {
        const QString file = at("plan.mrk.json");
        save(saved_, file);
        const ProgramRun run = runPlan({file, "-o", file});
        QCOMPARE(run.code, 1);
        QVERIFY(contents(file).contains("pdrender-plan"));
    }

    void wrongUsageIsTwo_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* name, const QStringList& options, const char* named) {
            QTest::newRow(name) << options << QByteArray(named);
        };
        row("no plan", {}, "needs one plan file");
        row("two plans", {"a", "b"}, "needs one plan file");
        row("unknown ending", {"a", "-o", "a.txt"}, "must end in .csv, .mrk.json, .png or .exr, not be a.txt");
        row("an image without --render", {"a", "--scan", "b", "-o", "a.png"}, "Add --render");
        row("--render without a file", {"a", "--scan", "b", "--render"}, "Add -o image.png");
        row("--render without the scan", {"a", "--render", "-o", "a.png"}, "--scan: says which scan");
        row("--labels without --render", {"a", "--scan", "b", "--labels", "c"}, "Add --render");
        row("--series without the scan", {"a", "--series", "1.2"}, "--scan: says which scan");
        row("size", {"a", "--scan", "b", "--render", "-o", "a.png", "--size", "9"}, "must look like 800x600");
    }

    void wrongUsageIsTwo() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, named);
        const ProgramRun run = runPlan(options);
        QCOMPARE(run.code, 2);
        QVERIFY2(run.err.contains(named), run.err.constData());
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::PlanCommandTest)
#include "plan_command_test.moc"
