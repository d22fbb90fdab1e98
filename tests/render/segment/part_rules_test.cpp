#include <QTest>

#include "render/segment/part_rules.h"
#include "tests/support/scenes/vessel_phantoms.h"

using namespace pdr;
using namespace pdr::segment;

/// Rules are chosen by name, several at once, and what they find is one map.
class PartRulesTest : public QObject {
    Q_OBJECT

  private slots:
    void namesAreReadAsTheyAreWritten() {
        for (const char* text : {"vessels", "shells", "mirror", "metal", "vessels,shells", "shells,mirror,metal"}) {
            const auto rules = partRulesFrom(text);
            QVERIFY2(bool(rules), text);
            QCOMPARE(partRulesText(*rules), std::string(text));
        }
        QVERIFY(*partRulesFrom("shells,vessels,shells") == (PartRules{PartRule::vessels, PartRule::shells}));
        QCOMPARE(partRulesText({}), std::string());
    }

    void otherNamesAreRefused() {
        for (const char* text : {"", "bones", "vessels,", ",vessels", "vessels, shells", "Vessels"}) {
            const auto rules = partRulesFrom(text);
            QVERIFY2(!rules && rules.error().what.find("vessels") != std::string::npos, text);
        }
    }

    /// Soft tissue lies around vessels, and each rule finds what it finds alone.
    void severalRulesMakeOneMap() {
        const Volume scan = test::scanOf(test::aortaBesideSpine());
        const auto all = findParts(PartRules{PartRule::vessels, PartRule::shells}, scan, noProgress);
        const auto vessels = findParts(PartRule::vessels, scan, noProgress);
        QVERIFY(all && vessels);
        QCOMPARE(all->parts.size(), std::size_t(3));
        QVERIFY(all->parts[0].name == "vessels" && all->parts[1].name == "skin" && all->parts[2].name == "muscle");
        std::size_t kept = 0, found = 0;
        for (std::size_t i = 0; i < vessels->labels.size(); ++i) {
            found += vessels->labels[i] == 1;
            kept += vessels->labels[i] == 1 && all->labels[i] == 1;
        }
        QVERIFY2(found > 1000 && kept == found, qPrintable(QString("%1 of %2").arg(kept).arg(found)));
        QVERIFY(partsMl(*all)[2] > 100 && all->notes.size() >= 2);
    }

    /// The second rule's progress begins where the first one's ends.
    void progressGoesOn() {
        double before = 0, back = 0;
        const auto found = findParts(PartRules{PartRule::vessels, PartRule::shells},
                                     test::scanOf(test::aortaBesideSpine()), [&](double done, std::string_view) {
                                         back = std::max(back, before - done);
                                         before = done;
                                         return true;
                                     });
        QVERIFY2(found && back < 0.4 && before > 0.8, qPrintable(QString("%1 %2").arg(back).arg(before)));
    }
};

QTEST_APPLESS_MAIN(PartRulesTest)
#include "part_rules_test.moc"
