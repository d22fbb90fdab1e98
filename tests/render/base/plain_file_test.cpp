#include <QtTest>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <QTemporaryDir>

#include <fstream>

#include "render/base/plain_file.h"

using namespace pdr;

class PlainFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::filesystem::path at(const char* name) const { return folder_.filePath(name).toStdString(); }
    static QString refusalOf(const std::filesystem::path& path) {
        const auto checked = checkPlainFile(path);
        const auto read = readPlainFile(path, 100);
        if (checked)
            return {};
        return read ? "read all the same" : QString::fromStdString(read.error().text());
    }

  private slots:
    void whatIsInTheFileIsRead() {
        std::ofstream(at("a")) << "some text";
        QVERIFY(bool(checkPlainFile(at("a"))));
        QCOMPARE(*readPlainFile(at("a"), 9), std::string("some text"));
        std::ofstream(at("empty"));
        QCOMPARE(*readPlainFile(at("empty"), 0), std::string());
        std::filesystem::create_symlink("a", at("link"));
        QCOMPARE(*readPlainFile(at("link"), 9), std::string("some text"));
        const std::string large(300'000, 'x');
        std::ofstream(at("large")) << large;
        QCOMPARE(*readPlainFile(at("large"), 300'000), large);
    }

    void moreThanIsAllowedIsRefused() {
        std::ofstream(at("b")) << "some text";
        const auto refused = readPlainFile(at("b"), 8);
        QVERIFY(!refused && refused.error().what.find("larger than") != std::string::npos);
    }

    void whatIsNoFileIsRefusedAndNotWaitedFor() {
        QCOMPARE(::mkfifo(at("pipe").c_str(), 0600), 0);
        std::filesystem::create_symlink("/dev/zero", at("zero"));
        QVERIFY(refusalOf(at("pipe")).contains("no plain file"));
        QVERIFY(refusalOf(at("zero")).contains("no plain file"));
        QVERIFY(refusalOf(folder_.path().toStdString()).contains("a folder"));
    }

    void theSystemsReasonIsGiven() {
        QVERIFY(refusalOf(at("nowhere")).contains("No such file"));
        std::ofstream(at("c")) << "c";
        rlimit before{};
        ::getrlimit(RLIMIT_NOFILE, &before);
        const rlimit none{3, before.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &none);
        const QString full = refusalOf(at("c"));
        ::setrlimit(RLIMIT_NOFILE, &before);
        QVERIFY2(full.contains("Too many open files") && full.contains("ulimit -n"), qPrintable(full));
        ::chmod(folder_.path().toUtf8().constData(), 0755);
        ::chmod(at("c").c_str(), 0);
        const bool isRoot = ::geteuid() == 0 && ::seteuid(65534) == 0;
        const QString locked = refusalOf(at("c"));
        QVERIFY(!isRoot || ::seteuid(0) == 0);
        QVERIFY2(locked.contains("Permission denied"), qPrintable(locked));
    }
};

QTEST_APPLESS_MAIN(PlainFileTest)
#include "plain_file_test.moc"
