/// What the documents name exists: links, paths and tests. The README stays short enough to be read.

#include <QtTest>

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

#include "tests/support/document_text.h"
#include "tests/support/places.h"

namespace {

using pdr::test::caught;

const QDir kRoot(QStringLiteral(PDR_SOURCE_DIR));
constexpr int kReadmeWords = 900, kPageLines = 120;

/// `file`: a path from the root of the tree.
QString textOf(const QString& file) {
    return pdr::test::contents(kRoot.filePath(file));
}

/// Documents of the tree, as paths from its root.
QStringList documents() {
    QStringList found{"README.md", "CHANGELOG.md", "DECISIONS.md"};
    for (const char* room : {"resources", "tests", "tools", "installer"}) {
        QDirIterator walk(kRoot.filePath(room), {"*.md"}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            found << kRoot.relativeFilePath(walk.next());
    }
    return found;
}

/// Targets of the links in `text` that lead into the tree, without their anchors; what stands in code is no link.
QStringList linksOf(QString text) {
    text.remove(QRegularExpression("`[^`\n]*`"));
    QStringList links = caught(R"(\]\(([^)#\s]+)[^)]*\))", text);
    links.removeIf([](const QString& link) { return link.contains("://") || link.startsWith("mailto:"); });
    return links;
}

/// Paths from the root of the tree that `text` shows as code, patterns and commands left out.
QStringList pathsOf(const QString& text) {
    return caught("`((?:app|cmake|dicom|installer|render|resources|tests|tools|ui)/[\\w./-]*)`", text);
}

}  // namespace

class DocumentsTest : public QObject {
    Q_OBJECT

  private slots:
    void readmeIsReadInFourMinutes() {
        const int words = int(textOf("README.md").split(QRegularExpression("\\s+"), Qt::SkipEmptyParts).size());
        QVERIFY(words > 300);
        QVERIFY2(words <= kReadmeWords, qPrintable(QString("%1 words").arg(words)));
    }

    void everyPageOfTheManualIsAPage() {
        const QDir manual(kRoot.filePath("resources/manual"));
        for (const QString& page : manual.entryList({"*.md"})) {
            const qsizetype lines = pdr::test::contents(manual.filePath(page)).count('\n');
            QVERIFY2(lines <= kPageLines, qPrintable(QString("%1: %2 lines").arg(page).arg(lines)));
        }
    }

    void everyLinkLeadsToAFile() {
        int seen = 0;
        for (const QString& document : documents())
            for (const QString& link : linksOf(textOf(document))) {
                const QString target = kRoot.filePath(QFileInfo(document).path() + "/" + link);
                QVERIFY2(QFileInfo::exists(target), qPrintable(document + ": " + link));
                ++seen;
            }
        QVERIFY(seen > 60);
    }

    void everyPathNamedExists() {
        for (const QString& document : documents())
            if (document == "README.md" || document == "tests/PROMISES.md" || document.startsWith("resources/manual/"))
                for (const QString& path : pathsOf(textOf(document)))
                    QVERIFY2(QFileInfo::exists(kRoot.filePath(path)), qPrintable(document + ": " + path));
    }

    void everyPageOfTheManualIsInItsIndex() {
        const QStringList listed = linksOf(textOf("resources/manual/index.md"));
        const QStringList pages = QDir(kRoot.filePath("resources/manual")).entryList({"*.md"});
        QVERIFY(pages.size() > 6);
        for (const QString& page : pages)
            QVERIFY2(page == "index.md" || listed.contains(page), qPrintable(page));
    }

    void everyTestThatAPromiseNamesExists() {
        QStringList tests;
        QDirIterator walk(kRoot.filePath("tests"), {"*_test.cpp"}, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            tests << QFileInfo(walk.next()).completeBaseName();
        const QStringList named = caught("`(\\w+_test)`", textOf("tests/PROMISES.md"));
        QVERIFY(named.size() > 50);
        for (const QString& each : named)
            QVERIFY2(tests.contains(each), qPrintable(each));
    }

    void anOmissionIsSeen() {
        QCOMPARE(linksOf("[a](b.md#c), [d](https://e), `[f](g)`, ![h](i/j.jpg \"k\")"),
                 QStringList({"b.md", "i/j.jpg"}));
        QCOMPARE(pathsOf("`render/film/film.cpp`, `tools/measure/`, `a/b`, `tests/mutations/run --check`"),
                 QStringList({"render/film/film.cpp", "tools/measure/"}));
    }
};

QTEST_APPLESS_MAIN(DocumentsTest)
#include "documents_test.moc"
