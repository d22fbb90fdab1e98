#include <QTest>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <cmath>

#include "app/bench/scale/measured_runs.h"
#include "app/bench/scale/played_pool.h"
#include "app/bench/scale/plot.h"
#include "app/bench/scale/report.h"
#include "app/bench/scale/settings.h"
#include "tests/support/patience.h"
#include "tests/support/places.h"

using namespace pdr;
using namespace pdr::bench;
using namespace pdr::bench::scale;

namespace {

std::string told(const Arguments& arguments) {
    const auto settings = settingsFrom(arguments);
    return settings ? "" : settings.error().text();
}

const Arguments kGiven{"--launch", "0.0003", "--sample", "1e-9", "--pixel", "1e-9", "--serial", "0.0005"};

Arguments with(Arguments words, const Arguments& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

ScalingFacts facts() {
    return settingsFrom(kGiven)->facts;
}

bool wellFormed(const QByteArray& xml) {
    QXmlStreamReader reader(xml);
    while (!reader.atEnd())
        reader.readNext();
    return !reader.hasError();
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray outputOf(const Arguments& arguments) {
    QStringList words{"scale"};
    for (const std::string& word : arguments)
        words << QString::fromStdString(word);
    QProcess program;
    program.start(QStringLiteral(PDR_BINARY_DIR "/bin/pdrender-bench"), words);
    if (!program.waitForFinished(test::kPatience) || program.exitCode() != 0)
        return {};
    return program.readAllStandardOutput();
}

constexpr const char* kRuns = R"({"format": "pdrender-scale-runs", "formatVersion": 1, "width": 480, "height": 270,
  "machine": "made up", "runs": [
    {"nodes": 1, "iterations": 256, "iterationsPerSecond": 10, "messages": 100, "bytes": 2000},
    {"nodes": 2, "iterations": 256, "iterationsPerSecond": 19.5}]})";

}  // namespace

class BenchScaleTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsGivenIsNotMeasured() {
        const auto settings = settingsFrom(with(kGiven, {"--width", "100", "--height", "50", "--samples", "640",
                                                         "--latency", "0.02", "--bandwidth", "1e9", "--tiles", "16"}));
        QVERIFY(settings);
        QVERIFY(!settings->measuresNode);
        QCOMPARE(settings->nodeOf({1, 1, 1, 1}).sample, 1e-9);
        QCOMPARE(settings->nodeOf({1, 1, 1, 1}).communication, 0.0005);
        QCOMPARE(settings->facts.work.pixels, 5000.0);
        QCOMPARE(settings->facts.work.iterations, 640u);
        QCOMPARE(settings->facts.link.latency, 0.02);
        QCOMPARE(settings->facts.tilesPerNode, 16.0);
        const auto some = settingsFrom({"--launch", "0.1"});
        QVERIFY(some && some->measuresNode);
        QCOMPARE(some->nodeOf({1, 2, 3, 4}).launch, 0.1);
        QCOMPARE(some->nodeOf({1, 2, 3, 4}).sample, 2.0);
    }

    void wrongWordsAreNamed() {
        QVERIFY(told({"--nodes", "0"}).find("--nodes 0") != std::string::npos);
        QVERIFY(told({"--bandwidth", "-1"}).find("--bandwidth -1") != std::string::npos);
        QVERIFY(told({"--latency", "soon"}).find("--latency soon") != std::string::npos);
        QVERIFY(told({"--mode", "x"}).find("--mode") != std::string::npos);
        QVERIFY(told({"--launch"}).find("value is missing") != std::string::npos);
        QVERIFY(told({"a.json", "b.json"}).find("b.json") != std::string::npos);
        QVERIFY(told({"--plots", "/proc/none/such"}).find("/proc/none/such") != std::string::npos);
    }

    void everyWayHasItsTableAndItsSource() {
        ScalingFacts some = facts();
        some.node = settingsFrom(kGiven)->nodeOf({});
        const Report report = reportOf("as given", some, 100'000);
        const QString text = QString::fromStdString(tables(report));
        for (int way = 0; way < kDistributions; ++way) {
            QVERIFY(text.contains(wayOf(Distribution(way)).name));
            QVERIFY(text.contains(wayOf(Distribution(way)).source));
            QCOMPARE(report.rows[way].front().told.nodes, 1.0);
            QCOMPARE(report.rows[way].back().told.nodes, 100'000.0);
        }
        QVERIFY(text.contains("eq. 5"));
        QVERIFY(text.contains("takes longer to launch than to sample: with tiles, from "));
    }

    void programsGetJson() {
        const QJsonObject json = QJsonDocument::fromJson(outputOf(with(kGiven, {"--json", "--nodes", "64"}))).object();
        QCOMPARE(json["format"].toString(), QString("pdrender-scale"));
        QCOMPARE(json["ways"].toArray().size(), kDistributions);
        QCOMPARE(json["facts"]["sampleSeconds"].toDouble(), 1e-9);
        const QJsonArray rows = json["ways"][0]["rows"].toArray();
        QCOMPARE(rows.last()["nodes"].toInt(), 64);
        QVERIFY(rows.last()["played"].isObject());
        QVERIFY(json["ways"][4]["rows"][0]["played"].isNull());
    }

    void plotsAreDrawings() {
        const QTemporaryDir folder;
        QVERIFY(!outputOf(with(kGiven, {"--plots", folder.path().toStdString()})).isEmpty());
        for (const char* name : {"rate.svg", "latency.svg", "efficiency.svg", "bytes.svg"}) {
            const QByteArray drawn = contents(folder.filePath(name));
            QVERIFY2(drawn.startsWith("<svg ") && wellFormed(drawn), name);
            QVERIFY(drawn.contains("<polyline"));
            QVERIFY(!drawn.contains("nan") && !drawn.contains("inf"));
        }
    }

    void aPlotLeavesOutWhatItCannotShow() {
        const std::string drawn = svg({"a < b & c", false, {{"x", {{1, 0}, {10, NAN}, {100, 5}}}}});
        QVERIFY(wellFormed(QByteArray::fromStdString(drawn)));
        QVERIFY(drawn.find("nan") == std::string::npos);
        QVERIFY(wellFormed(QByteArray::fromStdString(svg({"nothing", false, {}}))));
    }

    void aNodeIsMeasuredWhereNothingIsGiven() {
        const QJsonObject json =
            QJsonDocument::fromJson(outputOf({"--json", "--nodes", "4", "--seconds", "0.001", "--width", "96"}))
                .object();
        QVERIFY(json["facts"]["sampleSeconds"].toDouble() > 0);
        QVERIFY(json["facts"]["tileDeviation"].toDouble() > 0);
    }

    void runsAreHeldAgainstTheOneOfOneNode() {
        const auto runs = measuredRunsFrom(kRuns, "runs.json");
        QVERIFY(runs);
        QCOMPARE(runs->pixels(), 480.0 * 270);
        QCOMPARE(*runs->ofOne().messages, 100.0);
        ScalingFacts some = facts();
        some.node = settingsFrom(kGiven)->nodeOf({});
        const auto all = compared(*runs, some);
        QCOMPARE(all.size(), std::size_t(2));
        QVERIFY(std::fabs(all[0].off()) < 1e-6);
        QVERIFY(all[1].foretold > 19 && all[1].foretold < 20.1);
    }

    void bytesAreHeldAgainstThoseOfOneNode() {
        const auto runs = measuredRunsFrom(
            R"({"format": "pdrender-scale-runs", "formatVersion": 1, "width": 240, "height": 180, "cores": 2, "runs": [
                {"nodes": 1, "iterations": 512, "iterationsPerSecond": 80, "messages": 186, "bytes": 480000},
                {"nodes": 16, "iterations": 512, "iterationsPerSecond": 800, "bytes": 2000000},
                {"nodes": 2, "iterations": 512, "iterationsPerSecond": 160}]})",
            "runs.json");
        QVERIFY(runs && *runs->cores == 2);
        ScalingFacts some = facts();
        some.node = {0, 3e-7, 0, 0};
        const auto all = compared(*runs, some);
        QVERIFY(std::fabs(*all[0].bytesOff()) < 1e-9);
        QVERIFY(std::fabs(*all[1].bytesOff() - (*all[1].foretoldBytes / 2e6 - 1)) < 1e-9);
        QVERIFY(!all[2].bytesOff());
        QVERIFY(all[1].foretoldMessages > 2 * all[0].foretoldMessages);
        auto apart = *runs;  // as many cores as nodes: pieces are larger, and fewer
        apart.cores.reset();
        QVERIFY(compared(apart, some)[1].foretoldMessages < all[1].foretoldMessages);
    }

    /// A film takes each sample once, however many nodes there are; what they check each other for comes on top.
    void playedNodesSendWhatAnImageNeeds() {
        const ivec2 size{240, 180};
        for (const int nodes : {1, 3, 16}) {
            const PlayedResults results = playedResults(size, 512, {nodes, 3e-7, 1e-3});
            QVERIFY(results.sumPixels + results.deepPixels > size.x * size.y);
            QVERIFY(results.merged > nodes && results.sent >= results.merged);
            QVERIFY(nodes > 1 || results.sent == results.merged);  // there is nobody to check it but the coordinator
        }
        QCOMPARE(playedResults(size, 1 << 12, {4, 3e-7, 0}).sumPixels,
                 playedResults(size, 1 << 12, {4, 3e-7, 0}).sumPixels);
    }

    /// One node sends each pixel of tissue once, but for those of its first pieces, which lie above the tissue.
    void playedBackgroundTakesNoBytes() {
        const PlayedResults results = playedResults({240, 180}, 512, {1, 3e-7, 1e-3, 0.25});
        QCOMPARE(results.sumPixels, 0.0);
        QCOMPARE(results.deepPixels, 120.0 * 90);
    }

    void whatEndsTheGainIsSaid() {
        const QByteArray text = outputOf(with(kGiven, {"--relays", "3", "--nodes", "64"}));
        for (const NodeLimit limit : {NodeLimit::results, NodeLimit::orders, NodeLimit::messages, NodeLimit::tiles})
            QVERIFY2(text.contains(limitText(limit)), limitText(limit));
        QVERIFY(text.contains("3 relays"));
        const QJsonObject json = QJsonDocument::fromJson(outputOf(with(kGiven, {"--json", "--nodes", "64"}))).object();
        QCOMPARE(json["limits"].toArray().size(), 4);
        QCOMPARE(json["scan"].toArray().last()["nodes"].toInt(), 64);
    }

    /// One node spends 1 s of 10 s on 1000 pieces of work; two nodes have 600 each.
    void piecesOfWorkCostTime() {
        const auto runs = measuredRunsFrom(
            R"({"format": "pdrender-scale-runs", "formatVersion": 1, "width": 480, "height": 270, "clock": "processor",
                "leaseSeconds": 0.001, "runs": [
                {"nodes": 1, "iterations": 100, "iterationsPerSecond": 10, "messages": 2000},
                {"nodes": 2, "iterations": 100, "iterationsPerSecond": 19, "messages": 2400}]})",
            "runs.json");
        QVERIFY(runs && runs->byProcessor);
        ScalingFacts some = facts();
        some.node = {0, 1e-9, 0, 0};
        some.checkedPart = 0;
        some.tiles = TileCosts({1, 1, 1, 100});  // the last node works longer, and processors do not wait for it
        const auto all = compared(*runs, some);
        QVERIFY(std::fabs(all[0].off()) < 1e-6);
        QVERIFY(std::fabs(all[1].foretold - 100 / (0.6 + 9.0 / 2)) < 1e-3);
    }

    void whatSaysNothingAboutRunsIsRefused() {
        for (const char* text : {"", "[]", "{}", R"({"format": "pdrender-scale-runs", "formatVersion": 2})",
                                 R"({"format": "pdrender-scale-runs", "formatVersion": 1, "width": 4, "height": 4,
                                     "runs": [{"nodes": 2, "iterations": 1, "iterationsPerSecond": 1}]})",
                                 R"({"format": "pdrender-scale-runs", "formatVersion": 1, "width": 4, "height": 4,
                                     "runs": [{"nodes": 1, "iterations": 1, "iterationsPerSecond": 0}]})"}) {
            const auto runs = measuredRunsFrom(text, "runs.json");
            QVERIFY2(!runs, text);
            QCOMPARE(runs.error().where, std::string("runs.json"));
        }
    }
};

QTEST_GUILESS_MAIN(BenchScaleTest)
#include "bench_scale_test.moc"
