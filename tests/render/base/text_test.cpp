/// Sentences and what they are made of.

#include <QTest>

#include "render/base/result.h"
#include "render/base/text.h"

using namespace pdr;

class TextTest : public QObject {
    Q_OBJECT

  private slots:
    void aPhraseIsEnglishAndKnowsItsPattern() {
        const Text text = phrase("%2 files of %1, %3 mm", std::string("a.dcm"), 7, fixedNumber(1.25, 1));
        QCOMPARE(std::string(text), std::string("7 files of a.dcm, 1.2 mm"));
        QCOMPARE(text.pattern(), std::string("%2 files of %1, %3 mm"));
        QCOMPARE(text.arguments().size(), std::size_t(3));
        QCOMPARE(text.arguments()[0].kind(), Text::Kind::words);
        QCOMPARE(text.arguments()[1].kind(), Text::Kind::number);
        QCOMPARE(text.arguments()[2].kind(), Text::Kind::number);
    }

    /// A file's name may hold what looks like a place.
    void whatIsPutInIsNotReadAgain() {
        QCOMPARE(std::string(phrase("%1 and %2", std::string("50 %2"), std::string("b"))), std::string("50 %2 and b"));
        QCOMPARE(std::string(phrase("95 % of %1", 3)), std::string("95 % of 3"));
        QCOMPARE(std::string(phrase("%1 %2", 3)), std::string("3 %2"));
    }

    void aSentenceBeginsLargeAndEndsWithAStop() {
        QCOMPARE(std::string(Text::sentence(phrase("nothing is there"))), std::string("Nothing is there."));
        QCOMPARE(std::string(Text::sentence(phrase("%1 is empty.", std::string("a.dcm")))),
                 std::string("a.dcm is empty."));
        QVERIFY(Text::sentence({}).empty());
    }

    void sentencesAreJoinedBySpaces() {
        QCOMPARE(std::string(joined(phrase("One."), phrase("Two."))), std::string("One. Two."));
        QCOMPARE(std::string(joined({}, phrase("Two."))), std::string("Two."));
        QCOMPARE(std::string(joined(phrase("One."), {})), std::string("One."));
    }

    void numbersAreShort() {
        QCOMPARE(std::string(numberOf(0.75)), std::string("0.75"));
        QCOMPARE(std::string(numberOf(1e30)), std::string("1e+30"));
        QCOMPARE(std::string(numberOf(12.3456, 3)), std::string("12.3"));
        QCOMPARE(std::string(fixedNumber(6, 1)), std::string("6.0"));
    }

    void anErrorIsOneLine() {
        const Error error{phrase("it is empty"), "a.dcm", phrase("Copy it again.")};
        QCOMPARE(std::string(error.text()), std::string("a.dcm: it is empty. Copy it again."));
        QCOMPARE(std::string(Error{phrase("it is empty"), "", ""}.text()), std::string("it is empty"));
    }
};

QTEST_APPLESS_MAIN(TextTest)
#include "text_test.moc"
