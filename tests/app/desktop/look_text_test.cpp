/// Looks in the window's language: the program's own are translated, the user's are not, and files keep their names.

#include <QSet>
#include <QTest>

#include "app/looks/looks.h"
#include "app/presenters/look_text.h"
#include "tests/support/desktop/told_document.h"
#include "ui/text/language.h"

namespace pdr::app {

class LookTextTest : public QObject {
    Q_OBJECT

  private slots:
    void cleanup() { ui::speak(*qApp, "en"); }

    void inEnglishTheyAreAsInTheirFiles() {
        const std::vector<NamedLook> looks = *bundledLooks();
        for (const NamedLook& look : looks) {
            QCOMPARE(nameText(look).toStdString(), look.name);
            QCOMPARE(doesNotShowText(look).toStdString(), look.doesNotShow);
        }
        QCOMPARE(unsuitedText("no lungs are in this scan"), QString("no lungs are in this scan"));
        QCOMPARE(unsuitedText(""), QString());
    }

    void inOtherLanguagesTheyHaveOtherNames_data() {
        QTest::addColumn<QString>("bone");
        QTest::newRow("de") << "Knochen";
        QTest::newRow("es") << "Hueso";
    }
    void inOtherLanguagesTheyHaveOtherNames() {
        QFETCH(QString, bone);
        ui::speak(*qApp, QTest::currentDataTag());
        const std::vector<NamedLook> looks = *bundledLooks();
        QSet<QString> names;
        for (const NamedLook& look : looks) {
            names << nameText(look);
            QVERIFY(look.name == "MIP" || look.name == "Implants" ||
                    nameText(look) != QString::fromStdString(look.name));
            QVERIFY(doesNotShowText(look) != QString::fromStdString(look.doesNotShow));
        }
        QCOMPARE(names.size(), qsizetype(looks.size()));
        QVERIFY(names.contains(bone));
        const std::string reason = whyUnsuited(looks[0], {});
        QVERIFY(reason.empty() || unsuitedText(reason) != QString::fromStdString(reason));
    }

    /// The user's own look keeps its name even if that is the name of a bundled look; the name of a changed look says
    /// so.
    void theUsersOwnKeepsItsName() {
        ui::speak(*qApp, "de");
        std::vector<NamedLook> looks = *bundledLooks();
        NamedLook own = looks.front();
        own.group = LookGroup::own;
        own.name = own.doesNotShow = "Bones";
        QCOMPARE(nameText(own), QString("Bones"));
        QCOMPARE(doesNotShowText(own), QString("Bones"));
        looks.push_back(own);
        Document document(looks);
        document.open(cube());
        QCOMPARE(nameText(document.looks(), lookTitle(document.setup())), nameText(looks[0]));
        Look edited = document.setup().look;
        edited.gradientFactor += 1;
        document.setLook(edited);
        QCOMPARE(document.setup().lookName, looks[0].name);
        QVERIFY(document.setup().lookChanged);
        QCOMPARE(lookTitle(document.setup()), looks[0].name + " (changed)");  // for files, in any language
        QCOMPARE(nameText(document.looks(), lookTitle(document.setup())),
                 Document::tr("%1 (changed)").arg(nameText(looks[0])));
        QCOMPARE(nameText(document.looks(), "Bones"), QString("Bones"));
        QCOMPARE(nameText(document.looks(), "Bones of nobody"), QString("Bones of nobody"));
    }
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::LookTextTest)
#include "look_text_test.moc"
