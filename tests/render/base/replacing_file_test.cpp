#include <QtTest>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <QDir>
#include <QRegularExpression>
#include <QTemporaryDir>

#include <chrono>
#include <csignal>
#include <fstream>
#include <set>

#include "render/base/replacing_file.h"

using namespace pdr;

/// Ordinary rights for a while, where the test is run by root, who may do anything.
class OrdinaryUser {
  public:
    OrdinaryUser() { root_ = ::geteuid() == 0 && ::seteuid(65534) == 0; }
    ~OrdinaryUser() {
        if (root_ && ::seteuid(0) != 0)
            qFatal("the test cannot become root again");
    }

  private:
    bool root_;
};

class ReplacingFileTest : public QObject {
    Q_OBJECT

    std::unique_ptr<QTemporaryDir> folder_;
    std::filesystem::path at(const char* name) const { return folder_->filePath(name).toStdString(); }
    QStringList names() const {
        return QDir(folder_->path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::System | QDir::NoDotAndDotDot);
    }
    static void put(const std::filesystem::path& path, const std::string& text) { std::ofstream(path) << text; }
    static std::string textOf(const std::filesystem::path& path) {
        std::string text;
        std::getline(std::ifstream(path), text);
        return text;
    }
    static mode_t modeOf(const std::filesystem::path& path) {
        struct stat facts {};
        return ::stat(path.c_str(), &facts) == 0 ? facts.st_mode & 07777 : 0;
    }
    static Result<void> replace(const std::filesystem::path& path, FileAccess access = FileAccess::everybody) {
        auto file = ReplacingFile::open(path, access);
        if (!file)
            return file.error();
        file->write("new", 3);
        return file->commit();
    }

  private slots:
    void init() {
        folder_ = std::make_unique<QTemporaryDir>();
        ::chmod(folder_->path().toUtf8().constData(), 0777);
        ::umask(022);
    }

    void aNewFileIsTheOwnersAloneWhereThatIsAskedFor() {
        QVERIFY(bool(replace(at("a"))) && bool(replace(at("b"), FileAccess::owner)));
        QCOMPARE(modeOf(at("a")), mode_t(0644));
        QCOMPARE(modeOf(at("b")), mode_t(0600));
    }

    void aReplacedFileKeepsItsMode() {
        for (const mode_t mode : {0600, 0640, 0664, 0755})
            for (const FileAccess access : {FileAccess::everybody, FileAccess::owner}) {
                put(at("a"), "old");
                ::chmod(at("a").c_str(), mode);
                QVERIFY(bool(replace(at("a"), access)));
                QCOMPARE(modeOf(at("a")), mode);
                QCOMPARE(textOf(at("a")), "new");
            }
    }

    /// While it is written, nobody else may read what only the owner may read in the end.
    void halfAFileIsTheOwnersAlone() {
        put(at("a"), "old");
        ::chmod(at("a").c_str(), 0640);
        for (const char* name : {"a", "b"}) {
            const auto file = ReplacingFile::open(at(name), FileAccess::owner);
            QVERIFY(bool(file));
            const QStringList parts = names().filter(".part");
            QCOMPARE(parts.size(), 1);
            QCOMPARE(modeOf(at(parts.front().toUtf8().constData())), mode_t(0600));
        }
    }

    void aFileWithoutWritePermissionIsRefused() {
        const OrdinaryUser user;
        put(at("a"), "old");
        ::chmod(at("a").c_str(), 0444);
        const auto refused = ReplacingFile::open(at("a"));
        QVERIFY(!refused);
        QCOMPARE(refused.error().where, at("a").string());
        QVERIFY2(refused.error().what.find("may not be written") != std::string::npos, refused.error().text().c_str());
        QCOMPARE(textOf(at("a")), "old");
        QCOMPARE(names(), QStringList{"a"});
    }

    /// In a sticky folder, like the shared folder for temporary files, only the owner of a file may replace it.
    void anotherUsersFileInAStickyFolderIsRefusedBeforehand() {
        if (::geteuid() != 0)
            QSKIP("only root can make another user's file");
        put(at("a"), "old");
        ::chmod(at("a").c_str(), 0666);
        ::chmod(folder_->path().toUtf8().constData(), 01777);
        const OrdinaryUser user;
        const auto refused = ReplacingFile::open(at("a"));
        QVERIFY(!refused);
        QVERIFY2(refused.error().what.find("belongs to another user") != std::string::npos,
                 refused.error().text().c_str());
        QVERIFY(bool(replace(at("mine"))));
        QVERIFY(bool(replace(at("mine"))));
    }

    void theFileBehindALinkIsReplaced() {
        std::filesystem::create_directory(at("there"));
        put(at("there/a"), "old");
        std::filesystem::create_symlink("there/a", at("one"));
        std::filesystem::create_symlink(at("one"), at("two"));
        QVERIFY(bool(replace(at("two"))));
        QVERIFY(std::filesystem::is_symlink(at("one")) && std::filesystem::is_symlink(at("two")));
        QCOMPARE(textOf(at("there/a")), "new");
        std::filesystem::create_symlink("there/b", at("three"));  // to a file that is not there yet
        QVERIFY(bool(replace(at("three"))));
        QVERIFY(std::filesystem::is_symlink(at("three")));
        QCOMPARE(textOf(at("there/b")), "new");
    }

    void linksInACircleAreRefused() {
        std::filesystem::create_symlink("one", at("two"));
        std::filesystem::create_symlink("two", at("one"));
        const auto refused = ReplacingFile::open(at("one"));
        QVERIFY(!refused && refused.error().what.find("links") != std::string::npos);
        std::filesystem::create_symlink("none/a", at("three"));
        const auto missing = ReplacingFile::open(at("three"));
        QVERIFY(!missing && missing.error().hint.find("Create the folder") != std::string::npos);
    }

    /// An unfinished file may hold a patient's image. The next program that writes to the folder removes it, but no
    /// file that is still being written.
    void whatAKilledProcessLeftIsTakenAwayAnHourLater() {
        const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(2);
        put(at(".pdr-abandoned.part"), "old");
        put(at(".pdr-fresh.part"), "new");
        put(at("precious.part"), "mine");
        const auto slow = ReplacingFile::open(at("slow"));
        QVERIFY(bool(slow));
        for (const QString& name : names())
            if (name != ".pdr-fresh.part")
                std::filesystem::last_write_time(at(name.toUtf8().constData()), old);
        const QStringList parts = names();
        QVERIFY(bool(replace(at("a"))));
        QStringList left = names();
        left.removeAll("a");
        QCOMPARE(left, QStringList(parts).filter(QRegularExpression("^(?!.pdr-abandoned.part$)")));
        QVERIFY(left.size() == 3 && left.contains(".pdr-fresh.part") && left.contains("precious.part"));
    }

    /// A process that was killed leaves its part; in a container the next one has the same number.
    void whatAKilledProcessLeftStandsInNobodysWay() {
        for (int i = 0; i < 200; ++i)
            put(at(".pdr-").string() + std::to_string(::getpid()) + "-" + std::to_string(i) + ".part", "stale");
        QVERIFY(bool(replace(at("a"))));
        QCOMPARE(textOf(at("a")), "new");
    }

    void thePartsNameCannotBeForeseen() {
        std::set<QString> seen;
        for (int i = 0; i < 20; ++i) {
            const auto file = ReplacingFile::open(at("a"));
            QVERIFY(bool(file));
            seen.insert(names().front());
            QVERIFY(names().front().startsWith(".pdr-") && names().front().size() > 16);
        }
        QCOMPARE(seen.size(), std::size_t(20));
        QVERIFY(names().isEmpty());
    }
};

QTEST_APPLESS_MAIN(ReplacingFileTest)
#include "replacing_file_test.moc"
