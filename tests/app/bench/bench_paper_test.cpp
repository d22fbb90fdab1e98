#include <QtTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <cmath>
#include <csignal>
#include <map>
#include <random>

#include "app/bench/paper/report.h"
#include "app/bench/paper/settings.h"
#include "app/bench/paper/text_table.h"
#include "render/timing/efficiency.h"
#include "tests/support/patience.h"
#include "tests/support/places.h"

using namespace pdr;
using namespace pdr::bench;
using namespace pdr::bench::paper;

namespace {

constexpr FrameTimeModel kTruth{0.05e-3, 5e-9, 2e-9, 0.3e-3};
constexpr double kKroesOther = 4e-3;

double truth(const Plan& plan, ivec2 size, WayPlace way) {
    const FrameWork work{double(size.x) * size.y, kWays[way].iterations, plan.samplesPerLaunch(kWays[way], size)};
    return frameSeconds(kTruth, work) + (way == kK0 ? kKroesOther : 0);
}

/// Returns a report as if measured: three runs of each cell, off by a relative normal error.
Report madeUp(double error, unsigned seed = 1) {
    Report report;
    report.setup = {"2026-01-01 00:00 UTC", "1.2.3",    "a processor", 8,
                    {"cuda", "a \"GPU\""},  "a driver", "a scene",     "unbiased"};
    report.plan.perLaunch = 10;
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0, 1);
    for (const ivec2 size : report.plan.sizes)
        for (int way = 0; way < kWayCount; ++way) {
            Cell cell{size, WayPlace(way), {}};
            for (int run = 0; run < 3; ++run)
                cell.runs.push_back(
                    {{10 * truth(report.plan, size, WayPlace(way)) * (1 + error * noise(random)), 10, 0.5}, 0.9});
            report.measured.cells.push_back(cell);
        }
    report.measured.complete = true;
    report.figures = figuresOf(report.measured, report.plan);
    return report;
}

bool near(std::optional<double> value, double expected) {
    return value && std::fabs(*value - expected) <= 1e-9 * std::fabs(expected);
}

/// Every table of `text` has lines of one length and one number of cells; returns how many tables there are.
int soundTables(const QString& text) {
    int tables = 0;
    QString before;
    for (const QString& line : text.split('\n')) {
        if (line.startsWith('|') && !before.startsWith('|'))
            ++tables;
        else if (line.startsWith('|') && (line.size() != before.size() || line.count('|') != before.count('|')))
            return -1;
        before = line;
    }
    return tables;
}

/// The rows of a CSV, by the names of its head; empty where a row has another number of fields.
std::vector<std::map<QString, QString>> rowsOf(const QString& csv) {
    const QStringList lines = csv.trimmed().split('\n'), head = lines.front().split(',');
    std::vector<std::map<QString, QString>> rows;
    for (const QString& line : lines.mid(1)) {
        const QStringList fields = line.split(',');
        if (fields.size() != head.size())
            return {};
        for (rows.emplace_back(); rows.back().size() < std::size_t(head.size());)
            rows.back()[head[qsizetype(rows.back().size())]] = fields[qsizetype(rows.back().size())];
    }
    return rows;
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

std::string told(const Arguments& arguments) {
    const auto settings = settingsFrom(arguments);
    return settings ? "" : settings.error().text();
}

}  // namespace

class BenchPaperTest : public QObject {
    Q_OBJECT

  private slots:
    void figuresFollowThePapersEquations() {
        const Report report = madeUp(0);
        const Plan& plan = report.plan;
        for (std::size_t i = 0; i < plan.sizes.size(); ++i) {
            const SizeFigures& size = report.figures.sizes[i];
            const auto time = [&](WayPlace way) { return truth(plan, plan.sizes[i], way); };
            const double iteration = time(kPd100) / 100;
            QVERIFY(near(size.framesPerSecond[kPd10], 1 / time(kPd10)));
            QVERIFY(near(size.iterationsPerSecond(kPd10), 10 / time(kPd10)));
            QVERIFY(near(size.iteration, iteration));
            QVERIFY(near(size.other[kK0], time(kK0) - iteration));
            QVERIFY(near(size.other[kK1], time(kK1) - iteration));
            for (const WayPlace way : {kPd1, kPd10, kPd100})
                QVERIFY(near(size.other[way], time(kPd1) - iteration));
            QVERIFY(near(size.efficiency[kK0], iteration / time(kK0)));
            QVERIFY(near(size.efficiency[kPd1], iteration / time(kPd1)));
            QVERIFY(near(size.efficiency[kPd10], 10 * iteration / (9 * iteration + time(kPd1))));
            QVERIFY(near(size.load[kPd1], 0.9));
        }
        QVERIFY(near(report.figures.communication[kPd1], *report.figures.sizes.back().other[kPd1]));
        QVERIFY(near(report.figures.communication[kK0], *report.figures.sizes.back().other[kK0]));
    }

    void goalsAreTheRatiosThatTheyName() {
        const Report report = madeUp(0);
        const auto goals = goalsOf(report.figures);
        const auto time = [&](ivec2 size, WayPlace way) { return truth(report.plan, size, way); };
        const ivec2 tile{60, 34}, whole{1920, 1080};
        QVERIFY(near(goals[0].here, 100 * time(tile, kK0) / time(tile, kPd100)));
        QVERIFY(near(goals[1].here, 100 * time(whole, kK0) / time(whole, kPd100)));
        const double iteration = time(tile, kPd100) / 100;
        QVERIFY(near(goals[2].here, (time(tile, kK0) - iteration) / (time(tile, kPd1) - iteration)));
        const SizeFigures& smallest = report.figures.sizes.back();
        const double n = std::ceil(199 * *smallest.other[kPd1] / iteration);  // 0.995 / 0.005 = 199
        QVERIFY(goals[3].what.find("n=" + std::to_string(int(n)) + ",") != std::string::npos);
        QVERIFY(near(goals[3].here, n * iteration / (n * iteration + *smallest.other[kPd1])));
        QVERIFY(*goals[3].here >= *goals[3].wanted);
        QVERIFY(near(goals[4].here, *smallest.efficiency[kPd100]));
        QVERIFY(near(goals[5].here, 1e-6 * 1920 * 1080 * 100 / time(whole, kPd100)));
    }

    /// Noise of half the mean: 2500 samples until 1 %.
    void accuracyCostsWholeFrames() {
        const Report report = madeUp(0);
        for (const SizeFigures& size : report.figures.sizes) {
            QVERIFY(near(size.samplesToError(), 2500));
            QVERIFY(near(size.secondsToError(kPd1), 2500 * truth(report.plan, size.size, kPd1)));
            QVERIFY(near(size.secondsToError(kPd100), 25 * truth(report.plan, size.size, kPd100)));
        }
    }

    void fitFindsTheTimesThatWereMadeUp() {
        const Report exact = madeUp(0);
        QVERIFY(exact.figures.fit.has_value());
        QVERIFY(std::fabs(exact.figures.fit->model().launch / kTruth.launch - 1) < 1e-6);
        const Report noisy = madeUp(0.02);
        const FrameTimeFit& fit = *noisy.figures.fit;
        QVERIFY(fit.launch().holds(kTruth.launch));
        QVERIFY(fit.sample().holds(kTruth.sample));
        QVERIFY(fit.pixel().holds(kTruth.pixel));
        QVERIFY(fit.communication().holds(kTruth.communication));
    }

    /// The share of full speed is n alpha R / T, and eq. 5 promises more by the floors.
    void smallTilesKeepLessThanEquationFivePromises() {
        const Report report = madeUp(0);
        const TileEfficiency& tile = report.figures.tiles.back();
        QCOMPARE(text(tile.size), std::string("60x34"));
        QCOMPARE(tile.way, kPd100);
        const FrameWork work{2040, 100, 10};
        QVERIFY(std::fabs(tile.fraction - sampleShare(kTruth, work)) < 1e-6);
        QVERIFY(tile.manyNodes > tile.fraction + 0.2);
        QVERIFY(markdown(report).find("eq. 5 is optimistic here") != std::string::npos);
    }

    void reportIsWellFormed() {
        const Report report = madeUp(0.02);
        const QString text = QString::fromStdString(markdown(report));
        QCOMPARE(soundTables(text), 10);
        QVERIFY(!text.contains("these figures are not its own"));
        QVERIFY(!text.contains("INCOMPLETE") && !text.contains("nan") && !text.contains("inf"));
        const auto rows = rowsOf(QString::fromStdString(csv(report)));
        QCOMPARE(int(rows.size()), 30);
        const auto parsed = QJsonDocument::fromJson(QByteArray::fromStdString(json(report))).object();
        QCOMPARE(parsed["cells"].toArray().size(), 30);
        QVERIFY(parsed["complete"].toBool());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const QJsonObject cell = parsed["cells"][int(i)].toObject();
            QCOMPARE(cell["way"].toString(), rows[i].at("way"));
            QCOMPARE(cell["width"].toInt(), rows[i].at("width").toInt());
            for (const auto& [inJson, inCsv] : {std::pair("framesPerSecond", "frames_per_second"),
                                                std::pair("efficiency", "efficiency"), std::pair("load", "load")}) {
                const double value = cell[inJson].toDouble();
                QVERIFY(value > 0 && std::fabs(rows[i].at(inCsv).toDouble() / value - 1) < 1e-5);
            }
        }
    }

    void whatIsMissingIsNotMadeUp() {
        Report report = madeUp(0);
        report.measured.complete = false;
        report.measured.rounds = 1;
        for (std::size_t i = 0; i < kWayCount; ++i)
            report.measured.cells[i].runs.clear();  // 1920x1080
        report.measured.cells[kWayCount + kPd100].runs.clear();
        report.figures = figuresOf(report.measured, report.plan);
        const QString text = QString::fromStdString(markdown(report));
        QCOMPARE(soundTables(text), 10);
        QVERIFY(text.contains("INCOMPLETE: broken off in round 1 of 5"));
        QVERIFY(!text.contains("nan") && !text.contains("inf"));
        const auto rows = rowsOf(QString::fromStdString(csv(report)));
        QCOMPARE(int(rows.size()), 30);
        QCOMPARE(rows[0].at("frames_per_second"), QString());
        QCOMPARE(rows[0].at("frame_ms"), QString());
        QVERIFY(!rows[kWayCount].at("frames_per_second").isEmpty());
        QCOMPARE(rows[kWayCount].at("efficiency"), QString());
        const auto parsed = QJsonDocument::fromJson(QByteArray::fromStdString(json(report))).object();
        QVERIFY(parsed["cells"][0]["framesPerSecond"].isNull());
        QVERIFY(!parsed["complete"].toBool());
    }

    void sharedDeviceIsTold() {
        Report report = madeUp(0);
        for (Run& run : report.measured.cells[kPd100].runs)
            run.load = 0.4;
        report.figures = figuresOf(report.measured, report.plan);
        QVERIFY(markdown(report).find("the device was busy for only 40 %") != std::string::npos);
        report.plan.time = TimeOf::processor;  // others' share is left out
        QVERIFY(markdown(report).find("the device was busy for only") == std::string::npos);
        QVERIFY(markdown(report).find("* clock: processor time") != std::string::npos);
    }

    void nothingMeasuredIsAReportToo() {
        Report report = madeUp(0);
        for (Cell& cell : report.measured.cells)
            cell.runs.clear();
        report.figures = figuresOf(report.measured, report.plan);
        QVERIFY(!report.figures.fit);
        QVERIFY(markdown(report).find("Not fitted: too few measurements") != std::string::npos);
        QVERIFY(soundTables(QString::fromStdString(markdown(report))) > 0);
    }

    void numbersAreShortAndHonest() {
        QCOMPARE(digits(0.10789), std::string("0.1079"));
        QCOMPARE(digits(10.789), std::string("10.79"));
        QCOMPARE(digits(2498.3), std::string("2498"));
        QCOMPARE(digits(123456.7), std::string("123457"));
        QCOMPARE(digits(-0.5), std::string("-0.5000"));
        QCOMPARE(digits(0), std::string("0.000"));
        QCOMPARE(digits({}), std::string("-"));
        QCOMPARE(fraction(0.723), std::string("0.723"));
        QCOMPARE(fraction(0.99896), std::string("0.9990"));
        QCOMPARE(milliseconds(0.09268), std::string("92.68"));
        QCOMPARE(percent(0.976), std::string("98 %"));
    }

    void wrongOptionsAreTold() {
        QCOMPARE(told({"--foo", "3"}),
                 std::string("--foo: there is no such option. Run pdrender-bench without words to see them."));
        QCOMPARE(told({"--seconds"}), std::string("--seconds: the value is missing"));
        for (const char* bad : {"x", "-1", "0", "nan", "inf", "1e999", "1 "})
            QVERIFY(!told({"--seconds", bad}).empty());
        for (const char* bad : {"x", "-1", "0", "1.5"})
            QVERIFY(!told({"--rounds", bad}).empty());
        for (const char* bad : {"x", "12", "12x", "x12", "10x10", "240x135x", "-240x135"})
            QVERIFY(!told({"--largest", bad}).empty());
        QVERIFY(!told({"--estimator", "guess"}).empty());
        QVERIFY(!told({"--clock", "sun"}).empty());
        QVERIFY(!told({"--clock", "processor", "--device", "cuda"}).empty());
        QVERIFY(settingsFrom({"--clock", "processor", "--threads", "1"})->plan.time == TimeOf::processor);
        QVERIFY(!told({"a.json", "b.json"}).empty());
        QVERIFY(!told({"--out", "/no/such/folder"}).empty());
        const auto settings = settingsFrom({"s.json", "--largest", "240x135", "--seconds", "0.5", "--rounds", "2"});
        QVERIFY(bool(settings));
        QCOMPARE(int(settings->plan.sizes.size()), 3);
        QCOMPARE(settings->plan.seconds, 0.5);
        QCOMPARE(settings->plan.rounds, 2);
        QCOMPARE(settings->sceneFile, std::string("s.json"));
    }

    void filesThatCannotBeWrittenAreTold() { QVERIFY(!write(madeUp(0), "/no/such/folder")); }

    void programMeasuresAndWrites() {
        QTemporaryDir folder;
        QProcess process;
        process.start(PDR_BINARY_DIR "/bin/pdrender-bench",
                      {"paper", "--largest", "120x67", "--seconds", "0.02", "--rounds", "2", "--out", folder.path()});
        QVERIFY(process.waitForFinished(test::kPatience));
        QCOMPARE(process.exitCode(), 0);
        const QString shown = process.readAllStandardOutput();
        QCOMPARE(soundTables(shown), 8);  // two sizes are too few for a fit
        QVERIFY(shown.startsWith(QString::fromUtf8(contents(folder.filePath("paper.md")))));
        const auto rows = rowsOf(contents(folder.filePath("paper.csv")));
        QCOMPARE(int(rows.size()), 10);
        for (const auto& row : rows)
            QVERIFY(row.at("frames").toInt() >= 1 && row.at("frames_per_second").toDouble() > 0);
        const auto parsed = QJsonDocument::fromJson(contents(folder.filePath("paper.json"))).object();
        QCOMPARE(parsed["cells"].toArray().size(), 10);
        QVERIFY(parsed["complete"].toBool());
        QVERIFY(parsed["fit"].isNull());
    }

    void breakingOffKeepsWhatIsThere() {
        QTemporaryDir folder;
        QProcess process;
        process.start(PDR_BINARY_DIR "/bin/pdrender-bench",
                      {"paper", "--largest", "60x34", "--seconds", "600", "--out", folder.path()});
        QVERIFY(process.waitForStarted(test::kPatience));
        process.setReadChannel(QProcess::StandardError);
        QVERIFY(process.waitForReadyRead(test::kPatience));  // the first cell is being measured
        QTest::qWait(300);
        ::kill(pid_t(process.processId()), SIGINT);
        QVERIFY(process.waitForFinished(test::kPatience));
        QCOMPARE(process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(process.exitCode(), 1);
        QVERIFY(contents(folder.filePath("paper.md")).contains("INCOMPLETE: broken off in round 1 of 5"));
        QVERIFY(rowsOf(contents(folder.filePath("paper.csv")))[0].at("frames").toInt() > 1);
    }
};

QTEST_GUILESS_MAIN(BenchPaperTest)
#include "bench_paper_test.moc"
