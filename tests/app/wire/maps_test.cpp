/// The maps in frames: what later versions may add, and what is no map of ours.

#include <QCborArray>
#include <QCborMap>
#include <QCborValue>
#include <QTest>

#include "app/wire/map_reader.h"
#include "tests/app/wire/frame_hand.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

QByteArray mapOf(const Message& message) {
    const Bytes head = encode(message).head;
    return {reinterpret_cast<const char*>(head.data()) + kHeaderBytes, qsizetype(head.size() - kHeaderBytes)};
}

/// The message, with another map.
test::Heard heardWith(const Message& message, const QByteArray& map) {
    Frame frame = encode(message);
    const auto bytes = std::as_bytes(std::span(map.constData(), std::size_t(map.size())));
    const auto header = wire::bytesOf(
        {.type = typeOf(message), .mapBytes = std::uint32_t(map.size()), .payloadBytes = frame.payload.size()});
    frame.head.assign(header.begin(), header.end());
    frame.head.insert(frame.head.end(), bytes.begin(), bytes.end());
    return test::heardBy(test::readerOf(message), inOnePiece(frame));
}

test::Heard heardWith(const Message& message, const QCborMap& map) {
    return heardWith(message, QCborValue(map).toCbor());
}

bool understood(const Message& message, const test::Heard& heard) {
    return heard.error.empty() && heard.messages.size() == 1 && test::same(heard.messages[0], message);
}

QCborMap fieldsOf(const Message& message) {
    return QCborValue::fromCbor(mapOf(message)).toMap();
}

/// So many lists in each other.
QCborValue nested(int depth) {
    return depth == 0 ? QCborValue(1) : QCborValue(QCborArray{nested(depth - 1)});
}

/// One of everything.
QCborArray anything() {
    return {7,
            -7,
            1.5,
            true,
            QCborValue(QCborValue::Null),
            "text",
            QByteArray("bytes"),
            QCborArray{1, "a"},
            QCborMap{{1, 2}},
            QCborValue(QCborKnownTags::Url, "here")};
}

/// What may be left out: the first keys of the mask and of the surroundings.
bool isOptional(const Message& message, qint64 key) {
    return std::holds_alternative<SceneOrder>(message) && (key == 5 || key == 8);
}

}  // namespace

class MapsTest : public QObject {
    Q_OBJECT

  private slots:
    void fieldsOfLaterVersionsAreSkipped() {
        for (const Message& message : test::exampleMessages()) {
            QCborMap fields = fieldsOf(message);
            int key = 100;
            for (const QCborValue& value : anything())
                fields.insert(key++, value);
            fields.insert(key++, nested(kMostDepth - 1));
            fields.insert(QCborValue(qint64(1) << 40), 1);
            QVERIFY2(understood(message, heardWith(message, fields)), test::nameOf(message).c_str());
        }
    }

    void fieldsInBetweenAreSkipped() {
        const QByteArray tail = mapOf(Ping{3}).mid(1);  // behind "map"
        for (const char* before : {"0061"
                                   "78",
                                   "00c1c101", "00f6", "009f01ff", "00bf01ffff"}) {
            const test::Heard heard = heardWith(Ping{3}, "\xbf" + QByteArray::fromHex(before) + tail);
            QCOMPARE(understood(Ping{3}, heard), before != QByteArray("00bf01ffff"));  // a map without its value
        }
    }

    void allFieldsMustBeThere() {
        for (const Message& message : test::exampleMessages())
            for (const QCborValue& key : fieldsOf(message).keys()) {
                QCborMap fields = fieldsOf(message);
                fields.remove(key);
                const test::Heard heard = heardWith(message, fields);
                // Without its first key, what is optional is not there, and the rest of it is skipped.
                QCOMPARE(heard.error.empty(), isOptional(message, key.toInteger()));
            }
    }

    void fieldsMustBeOfTheirType() {
        for (const Message& message : test::exampleMessages())
            for (const QCborValue& key : fieldsOf(message).keys())
                for (const QCborValue& value : anything()) {
                    QCborMap fields = fieldsOf(message);
                    if (fields.value(key).type() == value.type() && !value.isArray() && !value.isByteArray())
                        continue;
                    fields[key] = value;
                    QVERIFY2(!heardWith(message, fields).error.empty(), test::nameOf(message).c_str());
                }
    }

    void listsAndBytesMustBeOfTheirLength() {
        for (const Message& message : test::exampleMessages())
            for (const QCborValue& key : fieldsOf(message).keys()) {
                QCborMap fields = fieldsOf(message);
                QCborValue value = fields.value(key);
                if (value.isArray()) {
                    QCborArray list = value.toArray();
                    list.append(list.at(0));
                    value = list;
                } else if (value.isByteArray())
                    value = value.toByteArray() + 'x';
                else
                    continue;
                fields[key] = value;
                QVERIFY2(!heardWith(message, fields).error.empty(), test::nameOf(message).c_str());
            }
    }

    void keysAscendAndAreThereOnce() {
        QVERIFY(understood(Ping{3}, heardWith(Ping{3}, QByteArray::fromHex("a10103"))));
        QVERIFY(understood(Ping{3}, heardWith(Ping{3}, QByteArray::fromHex("a201030205"))));
        QVERIFY(!heardWith(Ping{3}, QByteArray::fromHex("a201030104")).error.empty());
        QVERIFY(!heardWith(Ping{3}, QByteArray::fromHex("a202050103")).error.empty());
        QVERIFY(!heardWith(Ping{3}, QByteArray::fromHex("a3010302040201")).error.empty());
    }

    void thereAreNotTooManyKeys() {
        QCborMap fields = fieldsOf(Ping{3});
        for (int key = 2; key <= kMostKeys; ++key)
            fields.insert(key, 0);
        QVERIFY(understood(Ping{3}, heardWith(Ping{3}, fields)));
        fields.insert(kMostKeys + 1, 0);
        QVERIFY(!heardWith(Ping{3}, fields).error.empty());
    }

    void nothingIsTooDeep() {
        QCborMap fields = fieldsOf(Ping{3});
        fields.insert(2, nested(kMostDepth));
        QVERIFY(!heardWith(Ping{3}, fields).error.empty());
        const QByteArray deep(60000, '\x81');
        QVERIFY(!heardWith(Ping{3}, QByteArray::fromHex("bf010302") + deep).error.empty());
        QVERIFY(!heardWith(Ping{3}, deep).error.empty());
    }

    void whatIsNoMapOfOursIsRefused() {
        for (const char* map : {"",
                                "01",                      // a number
                                "8101",                    // a list
                                "bf",                      // cut
                                "bf01",                    //
                                "bf0103",                  //
                                "bf010300ff",              // a key that goes back
                                "bf0103fe",                // damaged
                                "bf0103ff00",              // something behind it
                                "a1012003",                // a negative number, and more
                                "a12003",                  // a negative key
                                "a1613103",                // a text as key
                                "a1c10103",                // a tagged key
                                "bb7fffffffffffffff0103",  // a promise of 2^63 fields
                                "bf010302"
                                "5b7fffffffffffffff"
                                "ff",  // a promise of 2^63 bytes
                                "bf010302"
                                "7b7fffffffffffffff"
                                "ff",
                                "bf010302"
                                "9b7fffffffffffffff"
                                "ff",
                                "bf010302"
                                "62c328"
                                "ff",               // no UTF-8
                                "d9d9f7bf0103ff"})  // a tagged map
            QVERIFY2(!heardWith(Ping{3}, QByteArray::fromHex(map)).error.empty(), map);
    }

    void textsMustBeLines() {
        for (const char* text : {"61"
                                 "0a",
                                 "61"
                                 "1b",
                                 "61"
                                 "7f",
                                 "62"
                                 "c285",
                                 "62"
                                 "c328",
                                 "7f61"
                                 "61ff",
                                 "64"
                                 "6161"}) {
            const test::Heard heard = heardWith(Bye{}, "\xbf\x01" + QByteArray::fromHex(text) + "\xff");
            QVERIFY2(!heard.error.empty(), text);
        }
        for (const std::size_t length : {kMostWordBytes, kMostWordBytes + 1}) {
            const test::Heard heard = heardWith(Bye{}, QCborMap{{1, QString(qsizetype(length), 'x')}});
            QCOMPARE(heard.error.empty(), length == kMostWordBytes);
        }
    }
};

QTEST_APPLESS_MAIN(MapsTest)
#include "maps_test.moc"
