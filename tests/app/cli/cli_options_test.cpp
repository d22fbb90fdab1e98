#include <QtTest>

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
