#include <QTemporaryDir>
#include <QTest>

#include <fstream>

#include "dicom/import.h"
#include "dicom/read/byte_source.h"
#include "dicom/read/file_structure.h"

using namespace pdr;
using namespace pdr::dicom;

namespace fs = std::filesystem;

namespace {

using Bytes = std::string;

Bytes little(std::uint32_t value, int count) {
    Bytes bytes;
    for (int i = 0; i < count; ++i)
        bytes += char(value >> 8 * i & 0xFF);
    return bytes;
}

Bytes tag(int group, int element) {
    return little(std::uint32_t(group), 2) + little(std::uint32_t(element), 2);
}

/// Preamble, and a meta header for implicit VR little endian.
Bytes head() {
    return Bytes(128, '\0').append("DICM") + tag(2, 0x10) + "UI" + little(18, 2) + "1.2.840.10008.1.2" + '\0';
}

Bytes repeated(const Bytes& part, int count) {
    Bytes all;
    for (int i = 0; i < count; ++i)
        all += part;
    return all;
}

Bytes sequenceOf(const Bytes& items) {
    return tag(8, 0x1140) + little(0xFFFFFFFF, 4) + items + tag(0xFFFE, 0xE0DD) + little(0, 4);
}

Bytes emptyItems(int count) {
    return sequenceOf(repeated(tag(0xFFFE, 0xE000) + little(0, 4), count));
}

}  // namespace

class BombsTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    fs::path file() const { return fs::path(folder_.path().toStdString()) / "file"; }

    FileStructure structureOf(const Bytes& bytes, const GoOn& goOn = always) const {
        std::ofstream(file(), std::ios::binary) << bytes;
        return checkStructure({file()}, goOn);
    }

  private slots:
    void emptyItemsAreCounted() {
        QCOMPARE(structureOf(head() + emptyItems(kMaxElements - 10)).damage, Bytes());
        const Bytes damage = structureOf(head() + emptyItems(1'000'000)).damage;
        QVERIFY2(damage.find("more than 50000 elements") != Bytes::npos, damage.c_str());
        // Nothing of it reaches the toolkit, which would build an object for each.
        const auto scan = scanFolder(folder_.path().toStdString(), noProgress);
        QVERIFY(bool(scan));
        QCOMPARE(scan->problems.size(), std::size_t(1));
        QVERIFY(scan->series.empty());
    }

    void smallElementsAreCounted() {
        const Bytes small = tag(8, 0x104) + little(2, 4) + "xx";
        QVERIFY(structureOf(head() + repeated(small, kMaxElements - 10)).damage.empty());
        QVERIFY(!structureOf(head() + repeated(small, kMaxElements + 10)).damage.empty());
    }

    /// What describes a frame is allowed for each, but no number of frames allows for everything.
    void framesAllowForTheirElements() {
        const Bytes small = tag(8, 0x104) + little(2, 4) + "xx";
        const auto withFrames = [&](const Bytes& count, int elements) {
            const Bytes frames = tag(0x28, 8) + little(std::uint32_t(count.size()), 4) + count;
            return structureOf(head() + frames + repeated(small, elements)).damage;
        };
        QCOMPARE(withFrames("1000", 10 * kMaxElements), Bytes());
        QVERIFY(!withFrames("10", 2 * kMaxElements).empty());
        QVERIFY(!withFrames("-1000 ", 2 * kMaxElements).empty());
        QVERIFY(withFrames("99999999", kMaxElementsOfAll + 10).find("more than 2000000 elements") != Bytes::npos);
    }

    void fragmentsAreCounted() {
        const Bytes open = tag(0x7FE0, 0x10) + little(0xFFFFFFFF, 4);
        const Bytes fragment = tag(0xFFFE, 0xE000) + little(2, 4) + "xx";
        const Bytes end = tag(0xFFFE, 0xE0DD) + little(0, 4);
        QVERIFY(structureOf(head() + open + repeated(fragment, 1000) + end).damage.empty());
        QVERIFY(!structureOf(head() + open + repeated(fragment, kMaxElements + 10) + end).damage.empty());
    }

    void valuesReadWithTheHeaderAreBounded() {
        const Bytes value = tag(8, 0x104) + little(4096, 4) + Bytes(4096, 'x');
        QVERIFY(structureOf(head() + repeated(value, 1000)).damage.empty());
        const Bytes damage = structureOf(head() + repeated(value, 17000)).damage;
        QVERIFY2(damage.find("more than 64 MB") != Bytes::npos, damage.c_str());
        // One long value that is no text stays in the file.
        QVERIFY(structureOf(head() + tag(9, 0x1004) + little(70 << 20, 4) + Bytes(70 << 20, 'x')).damage.empty());
    }

    /// The elements that are read of a header: character set, image type, modality, name, series and description.
    void listsOfManyValuesAreRefused_data() {
        QTest::addColumn<int>("group");
        QTest::addColumn<int>("element");
        QTest::newRow("character set") << 0x08 << 0x05;
        QTest::newRow("image type") << 0x08 << 0x08;
        QTest::newRow("modality") << 0x08 << 0x60;
        QTest::newRow("description") << 0x08 << 0x103E;
        QTest::newRow("name") << 0x10 << 0x10;
        QTest::newRow("series UID") << 0x20 << 0x0E;
    }
    void listsOfManyValuesAreRefused() {
        QFETCH(int, group);
        QFETCH(int, element);
        const auto text = [&](const Bytes& value) {
            return structureOf(head() + tag(group, element) + little(std::uint32_t(value.size()), 4) + value).damage;
        };
        QCOMPARE(text(repeated("1\\", kMaxListValues - 1)), Bytes());
        QVERIFY(text(repeated("1\\", kMaxListValues)).find("more than 1000 values") != Bytes::npos);
        QVERIFY(text(Bytes(300'000, '\\')).find("longer than 64 kB") != Bytes::npos);
        QCOMPARE(text(Bytes(kMaxListBytes, '1')), Bytes());
        QVERIFY(text(Bytes(kMaxListBytes + 2, '1')).find("longer than 64 kB") != Bytes::npos);
        // Nothing of it reaches the toolkit.
        const auto scan = scanFolder(folder_.path().toStdString(), noProgress);
        QVERIFY(bool(scan) && scan->problems.size() == 1 && scan->series.empty());
    }

    void listsInItemsAreCountedTogether() {
        const Bytes list = tag(8, 0x104) + little(2000, 4) + repeated("1\\", 1000).substr(0, 1998) + "11";
        const auto items = [&](int count) {
            return structureOf(head() + sequenceOf(repeated(tag(0xFFFE, 0xE000) + little(2008, 4) + list, count)))
                .damage;
        };
        QCOMPARE(items(40), Bytes());
        QVERIFY(items(60).find("more than 50000") != Bytes::npos);
    }

    /// Contours of radiotherapy are lists of thousands of numbers, and long reports one long text.
    void listsOfNumbersAndLongTextsAreNoDamage() {
        const Bytes numbers = repeated("1.5\\", 50'000), report(200'000, 'x');
        QCOMPARE(structureOf(head() + tag(0x3006, 0x50) + little(std::uint32_t(numbers.size()), 4) + numbers).damage,
                 Bytes());
        QCOMPARE(structureOf(head() + tag(0x40, 0xA160) + little(std::uint32_t(report.size()), 4) + report).damage,
                 Bytes());
    }

    void structureCheckAsksOftenWhetherToGoOn() {
        int asked = 0;
        const GoOn count = [&] { return ++asked > 0; };
        QVERIFY(structureOf(head() + emptyItems(40'000), count).damage.empty());
        QVERIFY(asked >= 40);
        asked = 0;
        const GoOn no = [&] { return ++asked < 1; };
        QCOMPARE(structureOf(head() + emptyItems(40'000), no).damage, Bytes("cancelled"));
        QCOMPARE(asked, 1);
    }

    void inflatingAsksOftenWhetherToGoOn() {
        // A stored block of zeros, many times: 64 MB.
        const Bytes block = Bytes("\0\xFF\xFF\0\0", 5) + Bytes(65535, '\0');
        const Bytes all = repeated(block, 1024) + Bytes("\1\0\0\xFF\xFF", 5);
        ByteSource source(std::vector<std::uint8_t>(all.begin(), all.end()));
        int asked = 0;
        QCOMPARE(inflateFrom(source, 0, std::size_t(1) << 30, [&] { return ++asked > 0; }).size(),
                 std::size_t(1024) * 65535);
        QVERIFY(asked >= 60);
        asked = 0;
        QVERIFY(inflateFrom(source, 0, std::size_t(1) << 30, [&] { return ++asked < 1; }).empty());
        QCOMPARE(asked, 1);
    }

    void inflatedBombTakesNoMemory() {
        const Bytes block = Bytes("\0\xFF\xFF\0\0", 5) + Bytes(65535, '\0');
        const Bytes all = repeated(block, 64) + Bytes("\1\0\0\xFF\xFF", 5);
        ByteSource source(std::vector<std::uint8_t>(all.begin(), all.end()));
        const auto inflated = inflateFrom(source, 0, 64 * 65535);
        QCOMPARE(inflated.size(), std::size_t(64) * 65535);
        QCOMPARE(inflated.capacity(), inflated.size());
        QVERIFY(inflateFrom(source, 0, 64 * 65535 - 1).empty());
    }
};

QTEST_APPLESS_MAIN(BombsTest)
#include "bombs_test.moc"
