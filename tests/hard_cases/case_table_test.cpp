/// The table in README.md is complete and true: every case is in it, every test that it names exists, and every test
/// is named.

#include <QtTest>

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include "tests/support/document_text.h"
#include "tests/support/places.h"

namespace {

using pdr::test::caught;
using pdr::test::contents;

const QString kFolder = QStringLiteral(PDR_SOURCE_DIR "/tests/hard_cases/");

/// The rows of a table: number to last column.
QMap<QString, QString> rowsOf(const QString& table) {
    QMap<QString, QString> rows;
    const QRegularExpression row("^\\| (B?\\d+) \\|.*\\|([^|]*)\\|$", QRegularExpression::MultilineOption);
    for (auto each = row.globalMatch(table); each.hasNext();) {
        const QRegularExpressionMatch match = each.next();
        rows[match.captured(1)] = match.captured(2);
    }
    return rows;
}

/// "file::function" of every test function in the folder.
QStringList tests() {
    QStringList found;
    QDirIterator walk(kFolder, {"*_test.cpp"}, QDir::Files);
    while (walk.hasNext()) {
        const QString path = walk.next(), file = QFileInfo(path).completeBaseName();
        for (const QString& function : caught("^    void (\\w+)\\(\\)", contents(path)))
            if (!function.endsWith("_data") && file != "case_table_test")
                found << file + "::" + function;
    }
    return found;
}

QStringList missing(const QStringList& wanted, const QStringList& there) {
    QStringList lost;
    for (const QString& each : wanted)
        if (!there.contains(each))
            lost << each;
    return lost;
}

const QString kTestName = "`(\\w+::\\w+)`";

}  // namespace

class CaseTableTest : public QObject {
    Q_OBJECT

  private slots:
    void everyCaseIsInTheTable() {
        const QMap<QString, QString> rows = rowsOf(contents(kFolder + "README.md"));
        QStringList numbers;
        for (int i = 1; i <= 74; ++i)
            numbers << QString::number(i);
        for (int i = 1; i <= 12; ++i)
            numbers << QStringLiteral("B%1").arg(i);
        QCOMPARE(missing(numbers, rows.keys()), QStringList());
        QCOMPARE(rows.size(), numbers.size());
        for (const QString& number : numbers)
            QVERIFY2(!caught(kTestName, rows[number]).isEmpty() || rows[number].contains("owed to"),
                     qPrintable(number));
    }

    void everyTestNamedExistsAndEveryTestIsNamed() {
        const QStringList named = caught(kTestName, contents(kFolder + "README.md")), written = tests();
        QVERIFY(written.size() > 50);
        QCOMPARE(missing(named, written), QStringList());
        QCOMPARE(missing(written, named), QStringList());
    }

    void anOmissionIsSeen() {
        const QMap<QString, QString> rows =
            rowsOf("| 1 | a | b | c | `x_test::y` |\n| B2 | a | b | c | owed to CUDA |\n");
        QCOMPARE(rows.keys(), QStringList({"1", "B2"}));
        QCOMPARE(caught(kTestName, rows["1"]), QStringList{"x_test::y"});
        QCOMPARE(missing({"a", "b"}, {"b"}), QStringList{"a"});
    }
};

QTEST_APPLESS_MAIN(CaseTableTest)
#include "case_table_test.moc"
