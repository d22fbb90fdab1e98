/// Looks in files: the user's own, and shared ones.

#include <sys/stat.h>
#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include "app/looks/look_files.h"
#include "app/looks/looks.h"
#include "app/looks/own_looks.h"

using namespace pdr;
using namespace pdr::app;

class OwnLooksTest : public QObject {
    Q_OBJECT

  private slots:
    void savedLooksComeBackToTheBit() {
        const QTemporaryDir folder;
        OwnLooks own(folder.filePath("deep/looks"));
        QVERIFY(own.read().looks.empty() && own.read().problems.empty());
        const std::vector<NamedLook> bundled = *bundledLooks();
        for (NamedLook look : bundled) {
            look.name = "my/" + look.name + ": ä?*";
            QVERIFY(own.save(look));
        }
        const OwnLooks::Read read = own.read();
        QVERIFY(read.problems.empty());
        QCOMPARE(read.looks.size(), bundled.size());
        for (const NamedLook& look : read.looks) {
            QVERIFY(look.group == LookGroup::own);
            const auto is = [&](const NamedLook& one) { return "my/" + one.name + ": ä?*" == look.name; };
            const auto drawn = std::ranges::find_if(bundled, is);
            QVERIFY(drawn != bundled.end() && drawn->look == look.look && drawn->cut == look.cut);
        }
        QVERIFY(QDir(folder.path()).entryList(QDir::Files).isEmpty());  // no name leaves the folder
    }

    void aLookIsRenamedAndDeleted() {
        const QTemporaryDir folder;
        OwnLooks own(folder.path());
        NamedLook look = bundledLooks()->front();
        look.name = "one";
        QVERIFY(own.save(look));
        QVERIFY(own.rename("one", "two"));
        QCOMPARE(own.read().looks.size(), std::size_t(1));
        QCOMPARE(own.read().looks[0].name, std::string("two"));
        QVERIFY(own.rename("two", "two"));
        QCOMPARE(own.read().looks.size(), std::size_t(1));
        QVERIFY(!own.rename("one", "three"));
        QVERIFY(!own.rename("two", " "));
        QVERIFY(!own.rename("two", std::string(100, 'x')));
        QVERIFY(own.remove("two"));
        QVERIFY(!own.remove("two"));
        QVERIFY(own.read().looks.empty());
    }

    void aBadFileIsToldAndTheOthersStay() {
        const QTemporaryDir folder;
        OwnLooks own(folder.path());
        QVERIFY(own.save(bundledLooks()->front()));
        QFile bad(folder.filePath("bad.json"));
        QVERIFY(bad.open(QIODevice::WriteOnly) && bad.write("{ \"format\": \"pdrender-look\" }") > 0);
        bad.close();
        QCOMPARE(own.read().looks.size(), std::size_t(1));
        QCOMPARE(own.read().problems.size(), std::size_t(1));
        QVERIFY(own.read().problems[0].text().find("bad.json") != std::string::npos);
    }

    /// The window must open all the same.
    void whatIsNoPlainFileIsNamedAndNotReadForEver() {
        const QTemporaryDir folder;
        OwnLooks own(folder.path());
        QVERIFY(own.save(bundledLooks()->front()));
        QVERIFY(QFile::link("/dev/zero", folder.filePath("zero.json")));
        QCOMPARE(::mkfifo(QFile::encodeName(folder.filePath("pipe.json")).constData(), 0600), 0);
        QVERIFY(QFile::link(folder.filePath("pipe.json"), folder.filePath("linked.json")));
        const OwnLooks::Read read = own.read();
        QCOMPARE(read.looks.size(), std::size_t(1));
        QVERIFY(!read.problems.empty());
        for (const Error& problem : read.problems)
            QVERIFY2(problem.what == "this is no plain file" && problem.where.ends_with(".json"),
                     problem.text().c_str());
        QVERIFY(!readLookFile(folder.filePath("pipe.json")));
    }

    void looksAreSharedInThreeFormats() {
        const QTemporaryDir folder;
        const NamedLook bone = bundledLooks()->front();
        for (const char* name : {"a.json", "b.vp.json", "c.vp"}) {
            const QString file = folder.filePath(name);
            QVERIFY(writeLookFile(bone, file));
            const auto again = readLookFile(file, bone);
            QVERIFY2(again, again ? "" : again.error().text().c_str());
            QVERIFY(again->look.rig == bone.look.rig);
        }
        QVERIFY(*readLookFile(folder.filePath("a.json")) == bone);
        QCOMPARE(readLookFile(folder.filePath("b.vp.json"), bone)->name, std::string("b"));
        QVERIFY(!writeLookFile(bone, folder.filePath("none/d.json")));
        QVERIFY(!readLookFile(folder.filePath("e.vp")));
    }
};

QTEST_GUILESS_MAIN(OwnLooksTest)
#include "own_looks_test.moc"
