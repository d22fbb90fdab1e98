/// The window in other languages: texts, plurals, numbers.

#include <QMenuBar>
#include <QTest>

#include "ui/series/series_panel.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/language.h"
#include "ui/text/series_text.h"
#include "ui/text/status_text.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestLanguage : public QObject {
    Q_OBJECT

  private slots:
    void cleanup() { speak(*qApp, "en"); }
    void theWindowSpeaksIt_data();
    void theWindowSpeaksIt();
    void numbersAreWrittenAsPeopleDo();
    void pluralsAgree();
    void whatIsUnknownIsEnglish();
};

void TestLanguage::theWindowSpeaksIt_data() {
    QTest::addColumn<QString>("code");
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("notice");
    QTest::newRow("en") << "en"
                        << "File"
                        << "Not for diagnostic use";
    QTest::newRow("de") << "de"
                        << "Datei" << QString::fromUtf8("Nicht für die Diagnose");
    QTest::newRow("es") << "es"
                        << "Archivo" << QString::fromUtf8("No apto para diagnóstico");
}

void TestLanguage::theWindowSpeaksIt() {
    QFETCH(QString, code);
    QFETCH(QString, file);
    QFETCH(QString, notice);
    speak(*qApp, code);
    MainWindow window;
    QCOMPARE(window.menuBar()->actions().front()->text().remove('&'), file);
    QVERIFY(window.windowTitle().contains(notice));
    QVERIFY2(window.width() <= 800 && window.minimumSizeHint().width() <= 800,
             qPrintable(QString::number(window.minimumSizeHint().width())));
}

void TestLanguage::numbersAreWrittenAsPeopleDo() {
    QCOMPARE(durationText(90), QString("1.5 min"));
    speak(*qApp, "de");
    QCOMPARE(durationText(90), QString("1,5 min"));
    QCOMPARE(number(12345.5, 1), QString("12345,5"));
    QVERIFY(gridText({0.5, 0.5, 2.5}).contains(QString::fromUtf8("0,50 × 0,50 × 2,5 mm")));
}

void TestLanguage::pluralsAgree() {
    speak(*qApp, "de");
    QVERIFY(makingText({"cpu", 1, 0, 1, 1}).startsWith("1 Abtastung,"));
    QVERIFY(makingText({"cpu", 1, 0, 2, 1}).startsWith("2 Abtastungen,"));
    QCOMPARE(SeriesPanel::tr("and %n more", nullptr, 3), QString("und 3 weitere"));
}

void TestLanguage::whatIsUnknownIsEnglish() {
    QCOMPARE(languageFor("xx"), languageFor(""));
    QVERIFY(languages().contains(languageFor("")));
    QCOMPARE(languageFor("de"), QString("de"));
    QCOMPARE(languageName("es"), QString::fromUtf8("Español"));
    QCOMPARE(languageName("en"), QString("English"));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestLanguage)
#include "language_test.moc"
