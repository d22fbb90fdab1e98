/// What is kept between two runs, and what is not.

#include <sys/stat.h>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "app/presenters/settings.h"

namespace pdr::app {

class TestSettings : public QObject {
    Q_OBJECT

  private slots:
    void foldersAreNotRememberedUnlessChosen();
    void theNewestEightAreRememberedOnce();
    void foldersAreRememberedWithTheWholeWay();
    void forgettingLeavesNothingInTheFile();
    void onlyTheOwnerMayReadThem_data();
    void onlyTheOwnerMayReadThem();
    void theOwnFolderIsTheOwnersAlone();
    void renderingHoldsWhereItIsGoodForPlanning();
    void coloursAreKept();
    void keysAreKept();
    void nodesAreKept();
    void whatIsNoNodeIsLeftOut();
};

struct Kept {
    QTemporaryDir folder;
    QString file = folder.filePath("settings.ini");
    Settings settings{file};

    QByteArray written() const {
        QSettings(file, QSettings::IniFormat).sync();
        QFile bytes(file);
        return bytes.open(QFile::ReadOnly) ? bytes.readAll() : QByteArray();
    }
};

void TestSettings::foldersAreNotRememberedUnlessChosen() {
    Kept kept;
    kept.settings.keepFolder("/patients/Doe");
    QVERIFY(!kept.settings.remembersFolders() && kept.settings.recentFolders().isEmpty());
    kept.settings.keepRemembersFolders(true);
    kept.settings.keepFolder("/patients/Doe");
    QCOMPARE(Settings(kept.file).recentFolders(), QStringList{"/patients/Doe"});
}

/// The default target is that of planning quality; an invalid target in the file does not count.
void TestSettings::renderingHoldsWhereItIsGoodForPlanning() {
    Kept kept;
    QCOMPARE(kept.settings.target(), 8.0);
    kept.settings.keepTarget(2);
    QCOMPARE(Settings(kept.file).target(), 2.0);
    kept.settings.keepTarget(-1);
    QCOMPARE(Settings(kept.file).target(), 8.0);
}

void TestSettings::theNewestEightAreRememberedOnce() {
    Kept kept;
    kept.settings.keepRemembersFolders(true);
    for (int i = 0; i < 10; ++i)
        kept.settings.keepFolder(QString("/%1").arg(i));
    kept.settings.keepFolder("/7");
    QCOMPARE(kept.settings.recentFolders(), QStringList({"/7", "/9", "/8", "/6", "/5", "/4", "/3", "/2"}));
}

/// The program may be started elsewhere the next time.
void TestSettings::foldersAreRememberedWithTheWholeWay() {
    Kept kept;
    kept.settings.keepRemembersFolders(true);
    const QString before = QDir::currentPath();
    QVERIFY(QDir::setCurrent(kept.folder.path()));
    kept.settings.keepFolder("../canary/in/");
    const QString whole = QDir::cleanPath(QDir::current().absoluteFilePath("../canary/in"));
    QDir::setCurrent(before);
    QCOMPARE(Settings(kept.file).recentFolders(), QStringList{whole});
    QSettings(kept.file, QSettings::IniFormat).setValue("recent/folders", QStringList{"in", "/out"});
    QCOMPARE(Settings(kept.file).recentFolders(), QStringList{"/out"});
}

void TestSettings::onlyTheOwnerMayReadThem_data() {
    QTest::addColumn<bool>("old");
    QTest::newRow("new") << false;
    QTest::newRow("of an earlier version") << true;
}

void TestSettings::onlyTheOwnerMayReadThem() {
    QFETCH(bool, old);
    ::umask(022);
    const QTemporaryDir folder;
    const QString file = folder.filePath("settings.ini");
    if (old) {
        QSettings(file, QSettings::IniFormat).setValue("theme", "dark");
        QVERIFY(QFile::permissions(file).testFlag(QFile::ReadOther));
    }
    {
        Settings settings(file);
        settings.keepRemembersFolders(true);
        settings.keepFolder("/patients/Doe");
    }
    struct stat facts {};
    QCOMPARE(::stat(file.toUtf8().constData(), &facts), 0);
    QVERIFY(facts.st_size > 0);
    QCOMPARE(facts.st_mode & 0777, mode_t(0600));
}

void TestSettings::theOwnFolderIsTheOwnersAlone() {
    ::umask(022);
    const QTemporaryDir folder;
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    Settings().keepDevice("cpu");
    struct stat facts {};
    QCOMPARE(::stat(folder.filePath("pd-render").toUtf8().constData(), &facts), 0);
    QCOMPARE(facts.st_mode & 0777, mode_t(0700));
    QCOMPARE(Settings().device(), QString("cpu"));
}

void TestSettings::forgettingLeavesNothingInTheFile() {
    Kept kept;
    kept.settings.keepRemembersFolders(true);
    kept.settings.keepFolder("/patients/Doe");
    kept.settings.keepRemembersFolders(false);
    QVERIFY(kept.settings.recentFolders().isEmpty());
    QVERIFY2(!kept.written().contains("Doe"), kept.written().constData());
}

void TestSettings::coloursAreKept() {
    Kept kept;
    QCOMPARE(kept.settings.theme(), ui::ThemeChoice::dark);
    kept.settings.keepTheme(ui::ThemeChoice::system);
    QCOMPARE(Settings(kept.file).theme(), ui::ThemeChoice::system);
    QSettings(kept.file, QSettings::IniFormat).setValue("theme", "mauve");
    QCOMPARE(Settings(kept.file).theme(), ui::ThemeChoice::dark);
}

void TestSettings::keysAreKept() {
    Kept kept;
    QVERIFY(kept.settings.keys().isEmpty());
    const QMap<QString, QString> keys{{"denoised", "Ctrl+Alt+S"}, {"table", ""}};
    kept.settings.keepKeys(keys);
    QCOMPARE(Settings(kept.file).keys(), keys);
    kept.settings.keepKeys({});
    QVERIFY(Settings(kept.file).keys().isEmpty());
}

void TestSettings::nodesAreKept() {
    Kept kept;
    QVERIFY(kept.settings.nodes().isEmpty() && !kept.settings.listenedPort() && kept.settings.certificates().isEmpty());
    kept.settings.keepNodes({"gpu-07:4743", "[::1]:9000"});
    kept.settings.keepListenedPort(9001);
    kept.settings.keepCertificates("/etc/pdrender/desktop");
    const Settings later(kept.file);
    QCOMPARE(later.nodes(), QStringList({"gpu-07:4743", "[::1]:9000"}));
    QCOMPARE(later.listenedPort(), std::optional<quint16>(9001));
    QCOMPARE(later.certificates(), QString("/etc/pdrender/desktop"));
    kept.settings.keepNodes({});
    kept.settings.keepListenedPort(std::nullopt);
    QVERIFY(Settings(kept.file).nodes().isEmpty() && !Settings(kept.file).listenedPort());
}

void TestSettings::whatIsNoNodeIsLeftOut() {
    Kept kept;
    QSettings file(kept.file, QSettings::IniFormat);
    file.setValue("nodes/addresses", QStringList{"gpu-07", "http://gpu-08", "gpu-07:4743", "", "gpu-09:0", "gpu-10:1"});
    file.setValue("nodes/listenedPort", 70000);
    file.sync();
    QCOMPARE(Settings(kept.file).nodes(), QStringList({"gpu-07:4743", "gpu-10:1"}));
    QVERIFY(!Settings(kept.file).listenedPort());
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestSettings)
#include "settings_test.moc"
