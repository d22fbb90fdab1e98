/// The seeds of the fuzzers and the golden frames, as they are and cut anywhere, heard by both sides (heard.h).

#include <QDirIterator>
#include <QFile>
#include <QTest>

#include "tests/fuzz/heard.h"
#include "tests/support/places.h"

using namespace pdr;

class CorpusTest : public QObject {
    Q_OBJECT

  private slots:
    void nothingInTheCorpusDoesHarm() {
        int files = 0;
        for (const char* folder : {"/tests/fuzz/corpus", "/tests/app/wire/golden/v1"})
            for (QDirIterator each(PDR_SOURCE_DIR + QString(folder), QDir::Files); each.hasNext(); ++files) {
                QFile file(each.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const QByteArray content = file.readAll();
                const auto bytes = std::as_bytes(std::span(content.constData(), std::size_t(content.size())));
                for (std::size_t end = 0; end <= bytes.size(); ++end)
                    for (const wire::Role role : {wire::Role::node, wire::Role::coordinator})
                        test::hearAnything(role, bytes.first(end));
            }
        QVERIFY(files > 30);
    }
};

QTEST_APPLESS_MAIN(CorpusTest)
#include "corpus_test.moc"
