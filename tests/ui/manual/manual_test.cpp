/// The manual inside the program: every page is there, links lead somewhere, and the search finds.

#include <QDir>
#include <QListWidget>
#include <QRegularExpression>
#include <QTest>
#include <QTextBrowser>

#include "tests/support/desktop/named_widget.h"
#include "tests/support/places.h"
#include "ui/manual/manual_window.h"

namespace pdr::ui {

class TestManual : public QObject {
    Q_OBJECT

  private slots:
    void everyPageIsInTheContents() {
        QStringList carried;
        for (const ManualPage& page : manualPages()) {
            QVERIFY2(page.text.size() > 100, qPrintable(page.file));
            carried << page.file;
        }
        QStringList written = QDir(QStringLiteral(PDR_SOURCE_DIR "/resources/manual")).entryList({"*.md"});
        carried.sort();
        written.sort();
        QCOMPARE(carried, written);
    }

    void everyLinkToAPageIsFollowed() {
        ManualWindow manual;
        const auto& browser = test::named<QTextBrowser>(manual, "Page");
        static const QRegularExpression link("\\]\\(([\\w-]+\\.md)(#[\\w-]+)?\\)");
        for (const ManualPage& page : manualPages())
            for (auto each = link.globalMatch(page.text); each.hasNext();) {
                const QRegularExpressionMatch match = each.next();
                manual.open(page.file);
                emit const_cast<QTextBrowser&>(browser).anchorClicked(QUrl(match.captured(1) + match.captured(2)));
                QCOMPARE(manual.page(), match.captured(1));
                QVERIFY2(browser.toPlainText().size() > 100, qPrintable(match.captured(1)));
            }
    }

    void theSearchListsPagesAndMarksTheWords() {
        ManualWindow manual;
        manual.show();
        auto& words = test::named<QLineEdit>(manual, "Search the manual");
        const auto& list = test::named<QListWidget>(manual, "Pages of the manual");
        const auto& browser = test::named<QTextBrowser>(manual, "Page");
        QCOMPARE(list.count(), int(manualPages().size()));
        words.setText("certificates TLS");
        QVERIFY(list.count() > 0 && list.count() < int(manualPages().size()));
        QCOMPARE(list.findItems("Render nodes for administrators", Qt::MatchExactly).size(), 1);
        QVERIFY(browser.extraSelections().size() > 1);
        words.setText("a-word-that-nobody-wrote");
        QCOMPARE(list.item(0)->text(), QString("No page has all of these words."));
        words.clear();
        QCOMPARE(manual.page(), QString("index.md"));
    }

    void backReturnsToThePageBefore() {
        ManualWindow manual;
        manual.open("accuracy.md");
        manual.open("no-such-page.md");
        QCOMPARE(manual.page(), QString("accuracy.md"));
        for (auto* button : manual.findChildren<QToolButton*>())
            if (button->text() == "Back")
                button->click();
        QCOMPARE(manual.page(), QString("index.md"));
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestManual)
#include "manual_test.moc"
