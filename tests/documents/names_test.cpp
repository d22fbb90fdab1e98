/// What comments and documents name exists: source files and options of the programs.

#include <QtTest>

#include <QDirIterator>
#include <QSet>

#include "tests/support/document_text.h"
#include "tests/support/places.h"

namespace {

using pdr::test::caught;

const QDir kRoot(QStringLiteral(PDR_SOURCE_DIR));

/// Files of the tree that match `filters`, as paths from its root.
QStringList files(const QStringList& filters) {
    QStringList found;
    for (const QString& file : kRoot.entryList(filters, QDir::Files))
        found << file;
    for (const char* room : {"app", "cmake", "dicom", "installer", "render", "resources", "tests", "tools", "ui"}) {
        QDirIterator walk(kRoot.filePath(room), filters, QDir::Files, QDirIterator::Subdirectories);
        while (walk.hasNext())
            found << kRoot.relativeFilePath(walk.next());
    }
    return found;
}

QString textOf(const QString& file) {
    return pdr::test::contents(kRoot.filePath(file));
}

const QStringList kSources{"*.h", "*.cpp", "*.cu", "*.cuh"};

/// Returns the source files that comments name: "film/display/tone_map.h".
QStringList namedFiles(const QString& text) {
    QStringList named;
    for (const QString& comment : caught("(//.*)$", text))
        named << caught(R"((?<![\w/.-])((?:[a-z_]+/)+[a-z_0-9]+\.(?:h|cpp|cu|md|py|sh|toml|cmake))\b)", comment);
    return named;
}

/// Returns the options in `text`, without their dashes.
QStringList optionsIn(const QString& text) {
    return caught("(?<![\\w-])--([a-z][a-z-]+)", text);
}

}  // namespace

class NamesTest : public QObject {
    Q_OBJECT

  private slots:
    /// A comment may leave out the rooms above: "transport/integrator.h".
    void everyFileThatACommentNamesExists() {
        QSet<QString> endings;
        for (const QString& file : files({"*"}))
            for (qsizetype at = 0; at >= 0; at = file.indexOf('/', at + 1))
                endings << file.mid(at == 0 ? 0 : at + 1);
        int seen = 0;
        for (const QString& file : files(kSources))
            for (const QString& named : namedFiles(textOf(file))) {
                QVERIFY2(endings.contains(named), qPrintable(file + ": " + named));
                ++seen;
            }
        QVERIFY(seen > 40);
    }

    void everyOptionThatADocumentNamesExists() {
        QString sources;
        for (const QString& file : files({"*.cpp", "*.py", "*.sh", "*.json", "bootstrap", "run", "standin_node",
                                          "gpu_check", "clang_tidy", "doc_comments"}))
            sources += textOf(file);
        const QStringList words = optionsIn(sources) + caught("\"([a-z][a-z-]+)\"", sources);
        const QSet<QString> known(words.begin(), words.end());
        int seen = 0;
        for (const QString& document : files({"*.md"})) {
            if (document.startsWith("installer/kubernetes/"))
                continue;  // names options of kubectl
            for (const QString& option : optionsIn(textOf(document))) {
                QVERIFY2(known.contains(option), qPrintable(document + ": --" + option));
                ++seen;
            }
        }
        QVERIFY(seen > 100);
    }

    void anOmissionIsSeen() {
        const QString slashes(2, '/');  // not written out: this file is read, too
        QCOMPARE(namedFiles(slashes + "/ See film/film.h and b/c.md.\nint a;  " + slashes + " (d/e.cpp)\n\"f/g.h\"\n"),
                 QStringList({"film/film.h", "b/c.md", "d/e.cpp"}));
        QCOMPARE(optionsIn("`--make-certificates FOLDER`, -o, a--b, --levels"),
                 QStringList({"make-certificates", "levels"}));
    }
};

QTEST_APPLESS_MAIN(NamesTest)
#include "names_test.moc"
