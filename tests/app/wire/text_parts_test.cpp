/// What a node says of itself can be said in the language of the coordinator's window, and is never more than it said.

#include <QTest>

#include <algorithm>

#include "app/wire/map_reader.h"
#include "app/wire/map_writer.h"
#include "app/wire/text_parts.h"
#include "render/base/errors.h"

namespace pdr {
namespace {

bool alike(const Text& a, const Text& b) {
    return std::string(a) == std::string(b) && a.kind() == b.kind() && a.pattern() == b.pattern() &&
           std::ranges::equal(a.arguments(), b.arguments(), alike);
}

Text sent(const Text& reason) {
    wire::MapWriter writer;
    writer.phrase(1, 2, reason);
    const wire::Bytes map = writer.finish();
    wire::MapReader reader(map);
    Text come;
    reader.phrase(1, 2, come);
    return reader.finish() ? Text("malformed") : come;
}

std::vector<Text> reasons() {
    return {notEnoughMemory(phrase("for the scene: %1", bytesText(13'370'000)), "", "").what,
            memoryTooSmall("cuda", 3'000'000'000, 20'000'000).text(),
            joined(Text::sentence(phrase("no answer")), phrase("Try again.")),
            phrase("%1: %2", std::string("\"quoted\" %2 \\ übermäßig"), 7),
            Text(std::string("words")),
            Text()};
}

}  // namespace

class TextPartsTest : public QObject {
    Q_OBJECT

  private slots:
    void reasonsKeepTheirPatternsOnTheirWay() {
        for (const Text& reason : reasons())
            QVERIFY2(alike(sent(reason), reason), reason.c_str());
    }

    /// An earlier node says words only, and an earlier coordinator reads them.
    void wordsAreThereWithoutParts() {
        const Text reason = reasons().front();
        QVERIFY(alike(wire::textOf(reason, ""), Text(std::string(reason))));
    }

    void whatSaysSomethingElseIsNotBelieved_data() {
        QTest::addColumn<QByteArray>("parts");
        QTest::newRow("another sentence") << QByteArray(R"(["all is well"])");
        QTest::newRow("no JSON") << QByteArray("[\"it is too");
        QTest::newRow("a number for a pattern") << QByteArray("[7]");
        QTest::newRow("empty") << QByteArray("[]");
        QTest::newRow("an object of nothing") << QByteArray("{}");
        QTest::newRow("null inside") << QByteArray(R"(["it is %1", null])");
        QByteArray bomb = R"("x")";
        for (int level = 0; level < 60; ++level)
            bomb = R"(["%1%1%1%1",)" + bomb + "]";
        QTest::newRow("grows without end") << bomb;
        QTest::newRow("deep") << QByteArray(500, '[') + "\"x\"" + QByteArray(500, ']');
    }
    void whatSaysSomethingElseIsNotBelieved() {
        QFETCH(QByteArray, parts);
        const std::string english = "it is too late";
        QVERIFY(alike(wire::textOf(english, parts.toStdString()), Text(english)));
    }

    /// The line says all that fits; half of its parts would say nothing.
    void tooLongForItsPartsIsStillSaid() {
        const Text reason = phrase("it holds %1", std::string(wire::kMostWordBytes - 12, 'x'));
        const Text come = sent(reason);
        QCOMPARE(std::string(come), std::string(reason));
        QVERIFY(come.kind() == Text::Kind::words);
    }
};

}  // namespace pdr

QTEST_APPLESS_MAIN(pdr::TextPartsTest)
#include "text_parts_test.moc"
