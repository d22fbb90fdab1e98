/// What one side tells is what the other side hears, and what no program of ours would tell is refused.

#include <QTest>

#include <limits>

#include "tests/app/wire/frame_hand.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

constexpr auto kHighest64 = std::numeric_limits<std::uint64_t>::max();
constexpr auto kHighest32 = std::numeric_limits<std::uint32_t>::max();
constexpr double kHighestReal = std::numeric_limits<double>::max();

template <std::size_t n>
std::array<std::byte, n> ones() {
    std::array<std::byte, n> bytes;
    bytes.fill(std::byte(0xff));
    return bytes;
}

std::string letters(std::size_t count) {
    return std::string(count, 'x');
}

bool survives(const Message& message) {
    const test::Heard heard = test::sent(message);
    return heard.error.empty() && heard.messages.size() == 1 && test::same(message, heard.messages[0]);
}

/// One of each type with the highest values, and one with the lowest.
std::vector<Message> extremes() {
    wire::Result result{.number = kHighest64,
                        .nonce = ones<16>(),
                        .revision = kHighest64,
                        .tile = {16383, 16383, 1, 1},
                        .samples = {std::uint64_t(1) << 53, 64},
                        .sums = test::unlikeSums(1),
                        .seconds = 1e9};
    for (FaultCount& fault : result.health.faults)
        fault = {kHighest64, kHighest64, kHighest32};
    SceneOrder order{.revision = kHighest64,
                     .volume = {ones<32>(), {2048, 1024, 1024}, {}},
                     .mask = MaskOrder{ones<32>(), {2048, 1024, 1024}, ivec3(15)},
                     .environment = EnvironmentOrder{ones<32>(), {16384, 8192}},
                     .labels = LabelsOrder{ones<32>()},
                     .text = letters(16 << 20)};
    order.volume.patientFromIndex.fill(-kHighestReal);
    return {
        Hello{{65535, 65535}, letters(64), letters(64), ones<16>(), ones<32>(), letters(64), letters(1024), kHighest64},
        Hello{},
        Welcome{65535, 60000, ones<32>()},
        Welcome{1, 100, {}},
        Refused{Refused::Why::unwanted, letters(1024)},
        Refused{Refused::Why::version, ""},
        Ping{kHighest64},
        Ping{},
        Pong{kHighest64},
        Pong{},
        order,
        SceneOrder{.volume = {{}, ivec3(1), {}}},
        Need{ones<32>(), kHighest32},
        Need{},
        Chunk{ones<32>(), kHighest32, kChunkBytes, Bytes(kChunkBytes + 1000)},
        Chunk{{}, 0, 1, Bytes(1)},
        SceneReady{kHighest64},
        SceneReady{},
        SceneRefused{kHighest64, letters(1024), kHighest32},
        SceneRefused{},
        Lease{kHighest64, ones<16>(), kHighest64, {0, 16383, 16384, 1}, {65, 63}, test::unlikeSums(16384)},
        Lease{0, {}, 0, {0, 0, 1, 1}, {0, 1}, {}},
        result,
        wire::Result{.tile = {0, 0, 512, 512}, .samples = {0, 1}, .sums = std::vector<PixelSums>(512 * 512)},
        Abandoned{kHighest64, ones<16>(), letters(1024)},
        Abandoned{},
        Bye{letters(1024)},
        Bye{},
    };
}

/// A message that a change has made malformed.
template <class OfType, class Change>
Message changed(OfType message, Change&& change) {
    change(message);
    return message;
}

std::vector<std::pair<const char*, Message>> senselessOrders() {
    const auto order = [](auto change) { return changed(test::exampleOrder(), change); };
    return {
        {"no voxels", order([](SceneOrder& o) { o.volume.size.x = o.mask->voxels.x = 0; })},
        {"too many along an axis", order([](SceneOrder& o) { o.volume.size.z = o.mask->voxels.z = 2049; })},
        {"too many voxels", order([](SceneOrder& o) {
             o.volume.size = o.mask->voxels = {2048, 1024, 1025};
         })},
        {"negative size", order([](SceneOrder& o) { o.volume.size.y = -512; })},
        {"NaN", order([](SceneOrder& o) { o.volume.patientFromIndex[3] = NAN; })},
        {"infinite", order([](SceneOrder& o) { o.volume.patientFromIndex[11] = -INFINITY; })},
        {"a mask of another volume", order([](SceneOrder& o) { o.mask->voxels.y = 2; })},
        {"a coarse mask", order([](SceneOrder& o) { o.mask->shift.y = 16; })},
        {"a negative shift", order([](SceneOrder& o) { o.mask->shift.y = -1; })},
        {"no texels", order([](SceneOrder& o) { o.environment->size.x = 0; })},
        {"a long side", order([](SceneOrder& o) { o.environment->size.y = 16385; })},
        {"too many texels", order([](SceneOrder& o) {
             o.environment->size = {16384, 8193};
         })},
        {"too long a text", order([](SceneOrder& o) { o.text = letters((16 << 20) + 1); })},
        {"no UTF-8", order([](SceneOrder& o) { o.text = "\xc3("; })},
    };
}

std::vector<std::pair<const char*, Message>> senselessWork() {
    const auto lease = [](auto change) { return changed(test::exampleLease(), change); };
    const auto result = [](auto change) { return changed(test::exampleResult(), change); };
    return {
        {"left of the image", lease([](Lease& l) { l.tile.x = -1; })},
        {"above the image", lease([](Lease& l) { l.tile.y = -1; })},
        {"beyond any image", lease([](Lease& l) { l.tile.x = 16380; })},
        {"below any image", lease([](Lease& l) { l.tile.y = 16382; })},
        {"no width", lease([](Lease& l) { l.tile.width = 0, l.before.clear(); })},
        {"no height", lease([](Lease& l) { l.tile.height = 0, l.before.clear(); })},
        {"negative width", lease([](Lease& l) { l.tile.width = -5; })},
        {"too many pixels", lease([](Lease& l) {
             l.tile = {0, 0, 513, 512}, l.before.clear();
         })},
        {"no samples", lease([](Lease& l) { l.samples.count = 0; })},
        {"too many samples", lease([](Lease& l) {
             l.samples = {192, 65}, l.before.clear();
         })},
        {"samples of two blocks", lease([](Lease& l) { l.samples.count = 57; })},
        {"samples that never come", lease([](Lease& l) { l.samples.first = (std::uint64_t(1) << 53) + 1; })},
        {"sums beside their hash", lease([](Lease& l) { l.kept.emplace(); })},
        {"sums before a block", lease([](Lease& l) { l.samples.first = 192; })},
        {"too few sums before", lease([](Lease& l) { l.before.pop_back(); })},
        {"too many sums before", lease([](Lease& l) { l.before.emplace_back(); })},
        {"no sums", result([](wire::Result& r) { r.sums.clear(); })},
        {"too few sums", result([](wire::Result& r) { r.sums.pop_back(); })},
        {"too many sums", result([](wire::Result& r) { r.sums.emplace_back(); })},
        {"a tile of another size", result([](wire::Result& r) { r.tile.width = 6; })},
        {"samples of two blocks", result([](wire::Result& r) { r.samples.first = 255; })},
        {"blocks that begin in one", lease([](Lease& l) {
             l.samples = {200, 128}, l.before.clear();
         })},
        {"blocks that end in one", lease([](Lease& l) {
             l.samples = {192, 130}, l.before.clear();
         })},
        {"too many blocks", lease([](Lease& l) {
             l.samples = {192, kMostDeepSamples + 64}, l.before.clear();
         })},
        {"too many pixels of blocks", lease([](Lease& l) {
             l.tile = {0, 0, 513, 256}, l.samples = {192, 128}, l.before.clear();
         })},
        {"moments before the first sample", changed(test::exampleDeepLease(), [](Lease& l) { l.samples.first = 0; })},
        {"too few moments before", changed(test::exampleDeepLease(), [](Lease& l) { l.moments.pop_back(); })},
        {"no moments", changed(test::exampleDeepResult(), [](wire::Result& r) { r.moments.clear(); })},
        {"too few moments", changed(test::exampleDeepResult(), [](wire::Result& r) { r.moments.pop_back(); })},
        {"too many moments", changed(test::exampleDeepResult(), [](wire::Result& r) { r.moments.emplace_back(); })},
        {"moments of one block", result([](wire::Result& r) { r.moments = test::unlikeMoments(15); })},
        {"negative seconds", result([](wire::Result& r) { r.seconds = -1e-300; })},
        {"NaN seconds", result([](wire::Result& r) { r.seconds = NAN; })},
        {"endless seconds", result([](wire::Result& r) { r.seconds = INFINITY; })},
        {"too many seconds", result([](wire::Result& r) { r.seconds = 1.1e9; })},
    };
}

std::vector<std::pair<const char*, Message>> senselessTalk() {
    const auto hello = [](auto change) { return changed(test::exampleHello(), change); };
    return {
        {"version 0", hello([](Hello& h) { h.versions.lowest = 0; })},
        {"versions upside down", hello([](Hello& h) {
             h.versions = {4, 3};
         })},
        {"version 0", Welcome{0, 1000, {}}},
        {"too quick a heart", Welcome{1, 99, {}}},
        {"too slow a heart", Welcome{1, 60001, {}}},
        {"refused for nothing", Refused{Refused::Why(0), ""}},
        {"refused for what nobody knows", Refused{Refused::Why(4), ""}},
        {"a place before the first", SceneRefused{1, "", 0}},
        {"a chunk of nothing", Chunk{{}, 0, 0, Bytes(9)}},
        {"a chunk that is too large", Chunk{{}, 0, kChunkBytes + 1, Bytes(9)}},
        {"a chunk without bytes", Chunk{{}, 0, 9, {}}},
        {"a chunk with too many bytes", Chunk{{}, 0, 9, Bytes(kChunkBytes + 20000)}},
    };
}

}  // namespace

class MessagesTest : public QObject {
    Q_OBJECT

  private slots:
    void whatIsSaidIsHeard() {
        const std::vector<Message> examples = test::exampleMessages();
        QCOMPARE(examples.size(), std::variant_size_v<Message>);
        for (std::size_t i = 0; i < examples.size(); ++i) {
            QCOMPARE(examples[i].index(), i);
            QVERIFY2(survives(examples[i]), test::nameOf(examples[i]).c_str());
        }
    }

    void leasesOfSeveralBlocksAreHeard() {
        for (const Message& message : test::exampleDeepMessages())
            QVERIFY2(survives(message), test::nameOf(message).c_str());
        wire::Result largest{.tile = {0, 0, 512, 256}, .samples = {0, kMostDeepSamples}};
        largest.sums.resize(kMostDeepPixels);
        largest.moments = test::unlikeMoments(kMostDeepPixels);
        QVERIFY(survives(largest));
        Lease first = test::exampleDeepLease();
        first.samples.first = 0;
        first.moments.clear();
        QVERIFY(survives(first));
    }

    void extremeValuesAreHeard() {
        for (const Message& message : extremes())
            QVERIFY2(survives(message), test::nameOf(message).c_str());
    }

    void aByeIsHeardByBoth() {
        const Bytes bytes = inOnePiece(encode(Bye{"enough"}));
        for (const Role role : {Role::coordinator, Role::node})
            QCOMPARE(test::heardBy(role, bytes).messages.size(), std::size_t(1));
    }

    void whatMakesNoSenseIsRefused() {
        for (const auto& all : {senselessOrders(), senselessWork(), senselessTalk()})
            for (const auto& [what, message] : all) {
                const test::Heard heard = test::sent(message);
                QVERIFY2(heard.messages.empty(), what);
                QVERIFY2(heard.error.starts_with(test::nameOf(message) + ": the other side sent what makes no sense"),
                         (what + (": " + heard.error)).c_str());
            }
    }

    void textsAreMadeLinesOnTheirWay() {
        const auto heardName = [](const std::string& name) {
            Hello hello = test::exampleHello();
            hello.name = name;
            return std::get<Hello>(test::sent(hello).messages.at(0)).name;
        };
        QCOMPARE(heardName("a\x1b[31m\tb\n"), std::string("a [31m b "));
        QCOMPARE(heardName("a\xff"), std::string("a\xef\xbf\xbd"));
        QCOMPARE(heardName(letters(63) + "ü"), letters(63));
        QCOMPARE(heardName(letters(62) + "ü"), letters(62) + "ü");
        QCOMPARE(heardName(letters(65)), letters(64));
    }

    void aLargeChunkIsNotCopied() {
        Chunk chunk{{}, 0, 9, Bytes(100000)};
        const std::byte* bytes = chunk.packed.data();
        Frame frame = encode(std::move(chunk));
        QCOMPARE(frame.payload.data(), bytes);
        const auto header = headerOf(Role::node, std::span(frame.head).first<kHeaderBytes>());
        QVERIFY(header);
        const auto message = decode(*header, std::span(frame.head).subspan(kHeaderBytes), std::move(frame.payload));
        QVERIFY(message && *message);
        QCOMPARE(std::get<Chunk>(**message).packed.data(), bytes);
    }
};

QTEST_APPLESS_MAIN(MessagesTest)
#include "messages_test.moc"
