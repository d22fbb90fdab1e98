#include <QtTest>

#include <QJsonDocument>
#include <cmath>

#include "app/cli/render/render_options.h"
#include "app/cli/render/render_report.h"
#include "tests/support/places.h"

using namespace pdr;
using namespace pdr::app;

class CliOptionsTest : public QObject {
    Q_OBJECT

    static Result<RenderOptions> options(const QStringList& more) {
        return renderOptions(QStringList{"folder", "-o", "a.png"} + more);
    }

  private slots:
    void aViewHasAWordAndTheLetterOfTheWindow_data() {
        QTest::addColumn<QString>("word");
        QTest::addColumn<int>("view");
        const auto row = [](const char* word, StandardView view) { QTest::newRow(word) << word << int(view); };
        row("anterior", StandardView::anterior);
        row("A", StandardView::anterior);
        row("front", StandardView::anterior);
        row("P", StandardView::posterior);
        row("back", StandardView::posterior);
        row("L", StandardView::left);
        row("r", StandardView::right);
        row("Right", StandardView::right);
        row("H", StandardView::superior);
        row("head", StandardView::superior);
        row("F", StandardView::inferior);
        row("feet", StandardView::inferior);
        row("inferior", StandardView::inferior);
    }

    void aViewHasAWordAndTheLetterOfTheWindow() {
        QFETCH(QString, word);
        QFETCH(int, view);
        const auto read = options({"--view", word});
        QVERIFY2(bool(read), read ? "" : read.error().text().c_str());
        QCOMPARE(int(*read->scene.view), view);
    }

    void anErrorMayBeAPercentage() {
        QCOMPARE(*options({"--error", "1%"})->stops.relativeError, 0.01);
        QCOMPARE(*options({"--error", "2.5 %"})->stops.relativeError, 0.025);
        QCOMPARE(*options({"--error", "0.01"})->stops.relativeError, 0.01);
        for (const char* wrong : {"0%", "101%", "%", "1%%", "one%", "1.5"})
            QVERIFY2(!options({"--error", wrong}), wrong);
        QVERIFY(!options({"--seconds", "5%"}));
    }

    void nodesAreCheckedInPartOrAll() {
        const auto read = [](const QStringList& more) { return options(QStringList{"--node", "localhost"} + more); };
        QVERIFY(!read({})->nodes.checksAll);
        QVERIFY(!read({"--check", "some"})->nodes.checksAll);
        QVERIFY(read({"--check", "all"})->nodes.checksAll);
        QVERIFY(!read({"--check", "none"}));
        QVERIFY(!options({"--check", "all"}));
    }

    void reportSaysWhatWasCheckedOfNodes() {
        RenderReport report{};
        QVERIFY(QJsonDocument::fromJson(jsonText(report).c_str())["nodes"].isNull());
        QVERIFY(plainText(report).find("tiles of render nodes") == std::string::npos);
        report.checks = {4096, 1000, 21};
        const QJsonValue nodes = QJsonDocument::fromJson(jsonText(report).c_str())["nodes"];
        QCOMPARE(nodes["tiles"].toInt(), 4096);
        QCOMPARE(nodes["checkedShare"].toDouble(), 0.021);
        QVERIFY(std::abs(nodes["foundOneIn200"].toDouble() - (1 - std::pow(0.979, 20.48))) < 1e-9);
        QVERIFY(plainText(report).find("2.1 % of 4096 tiles of render nodes were rendered twice") != std::string::npos);
    }

    void reportOfAnUnevenImageSaysSo() {
        RenderReport report{};
        report.result.film = {.samplesPerPixel = 1, .meanSamplesPerPixel = 30.5, .mostSamplesPerPixel = 64};
        const QJsonDocument json = QJsonDocument::fromJson(jsonText(report).c_str());
        QCOMPARE(json["samplesPerPixel"].toInt(), 1);
        QCOMPARE(json["meanSamplesPerPixel"].toDouble(), 30.5);
        QCOMPARE(json["mostSamplesPerPixel"].toInt(), 64);
        QVERIFY(plainText(report).find(" 1 to 64 samples per pixel") != std::string::npos);
    }

    void oneSampleIsNoPlural() {
        RenderReport report{};
        report.result.film.samplesPerPixel = 1;
        QVERIFY(plainText(report).find(" 1 sample per pixel") != std::string::npos);
        report.result.film.samplesPerPixel = 2;
        QVERIFY(plainText(report).find(" 2 samples per pixel") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(CliOptionsTest)
#include "cli_options_test.moc"
