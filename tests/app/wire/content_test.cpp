/// Contents on their way in chunks: what arrives is what was sent, or it is refused.

#include <QTest>

#include <random>

#include "app/wire/content.h"
#include "render/volume/phantom.h"
#include "tests/app/wire/example_messages.h"
#include "tests/app/wire/watched_memory.h"
#include "tests/support/processor_time.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

const auto kKey = test::counting<32>(1);

/// Voxels of a scan: noise in the lowest bits.
Bytes someContent(std::size_t bytes) {
    std::mt19937 random(4);
    Bytes content(bytes);
    for (std::size_t i = 0; i < bytes; ++i)
        content[i] = std::byte(i % 2 == 0 ? random() % 32 : i >> 18);
    return content;
}

ContentAssembly assemblyOf(const Bytes& content) {
    return {kKey, contentHash(kKey, content), content.size()};
}

}  // namespace

class ContentTest : public QObject {
    Q_OBJECT

  private slots:
    /// BLAKE2b-256 with key 01 02 ... 20, as Python's hashlib.blake2b(b"abc", digest_size=32, key=...) computes it.
    void theHashIsKeyedBlake2b() {
        const std::string_view text = "abc";
        const auto bytes = std::as_bytes(std::span(text));
        const Hash hash = contentHash(kKey, bytes);
        QCOMPARE(QByteArray(reinterpret_cast<const char*>(hash.data()), 32).toHex(),
                 QByteArray("280776135edcd561b55edb7abec985333c3995dda3d493de3d29ee5bc45fb333"));
        ContentHash parts(kKey);
        for (const std::byte& byte : bytes)
            parts.add(std::span(&byte, 1));
        QCOMPARE(parts.finish(), hash);
        QVERIFY(contentHash(test::counting<32>(2), bytes) != hash);
    }

    void contentsArriveInChunks() {
        for (const std::size_t bytes :
             {1u, 1000u, kChunkBytes - 1, kChunkBytes, kChunkBytes + 1, 3 * kChunkBytes - 7}) {
            const Bytes content = someContent(bytes);
            ContentAssembly assembly = assemblyOf(content);
            const std::uint32_t chunks = chunksOf(bytes);
            QCOMPARE(chunks, (bytes + kChunkBytes - 1) / kChunkBytes);
            for (std::uint32_t index = 0; index < chunks; ++index) {
                QCOMPARE(assembly.nextChunk(), index);
                QVERIFY(!assembly.isWhole());
                QVERIFY(assembly.add(packChunk(assembly.content(), content, index)));
            }
            QVERIFY(assembly.isWhole() && assembly.finish());
            QVERIFY(std::ranges::equal(assembly.bytes(), content));
        }
    }

    void scansGoThroughQuickly() {
        const Volume head = headPhantom({128, 115, 128}, {1.954, 2.8, 1.954});
        const auto voxels = std::as_bytes(head.voxels());
        const auto told = [&](const char* what, const test::ProcessorTime& spent) {
            qInfo("%s: %.0f MiB/s", what, double(voxels.size()) / (1 << 20) / spent.seconds());
        };
        const test::ProcessorTime hashing;
        ContentAssembly assembly(kKey, contentHash(kKey, voxels), voxels.size());
        told("named", hashing);
        std::vector<Chunk> chunks;
        const test::ProcessorTime packing;
        for (std::uint32_t index = 0; index < chunksOf(voxels.size()); ++index)
            chunks.push_back(packChunk(assembly.content(), voxels, index));
        told("packed", packing);
        const test::ProcessorTime assembling;
        for (const Chunk& chunk : chunks)
            QVERIFY(assembly.add(chunk));
        QVERIFY(assembly.finish());
        told("unpacked and checked", assembling);
        qInfo("%.2f of its size", double(chunks[0].packed.size()) / kChunkBytes);
    }

    void onlyTheNextChunkIsTaken() {
        const Bytes content = someContent(2 * kChunkBytes + 100);
        ContentAssembly assembly = assemblyOf(content);
        const auto chunk = [&](std::uint32_t index) { return packChunk(assembly.content(), content, index); };
        QVERIFY(!assembly.add(chunk(1)));
        QVERIFY(assembly.add(chunk(0)));
        QVERIFY(!assembly.add(chunk(0)));
        QVERIFY(!assembly.add(chunk(2)));
        Chunk foreign = chunk(1);
        foreign.content[0] ^= std::byte(1);
        QVERIFY(!assembly.add(foreign));
        QVERIFY(!assembly.finish());
        QVERIFY(assembly.add(chunk(1)) && assembly.add(chunk(2)));
        Chunk more = chunk(2);
        more.index = 3;
        QVERIFY(!assembly.add(more));
        QVERIFY(assembly.finish());
    }

    void chunksMustBeOfTheirLength() {
        const Bytes content = someContent(1000), longer = someContent(1001), shorter = someContent(999);
        ContentAssembly assembly = assemblyOf(content);
        for (const Bytes& other : {longer, shorter}) {
            Chunk chunk = packChunk(assembly.content(), other, 0);
            QVERIFY(!assembly.add(chunk));
            chunk.rawBytes = 1000;
            QVERIFY(!assembly.add(chunk));
        }
        Chunk chunk = packChunk(assembly.content(), content, 0);
        chunk.packed.push_back({});
        QVERIFY(!assembly.add(chunk));
        chunk.packed.resize(chunk.packed.size() - 2);
        QVERIFY(!assembly.add(chunk));
        chunk.packed.clear();
        QVERIFY(!assembly.add(chunk));
        QVERIFY(assembly.bytes().empty() && assembly.nextChunk() == 0);
        QVERIFY(assembly.add(packChunk(assembly.content(), content, 0)) && assembly.finish());
    }

    void aFlippedBitIsSeen() {
        Bytes content = someContent(3000);
        const Hash right = contentHash(kKey, content);
        for (std::size_t bit = 0; bit < 8 * content.size(); ++bit) {
            content[bit / 8] ^= std::byte(1) << bit % 8;
            ContentAssembly assembly(kKey, right, content.size());
            QVERIFY(assembly.add(packChunk(right, content, 0)));
            QVERIFY(!assembly.finish());
            content[bit / 8] ^= std::byte(1) << bit % 8;
        }
    }

    void aFlippedBitOnTheWayIsSeen() {
        const Bytes content = someContent(500);
        const Chunk chunk = packChunk(contentHash(kKey, content), content, 0);
        for (std::size_t bit = 0; bit < 8 * chunk.packed.size(); ++bit) {
            Chunk flipped = chunk;
            flipped.packed[bit / 8] ^= std::byte(1) << bit % 8;
            ContentAssembly assembly = assemblyOf(content);
            // A bit that means nothing to zstd may differ: then all that is unpacked is right.
            if (assembly.add(flipped) && assembly.finish())
                QVERIFY(std::ranges::equal(assembly.bytes(), content));
        }
    }

    void swappedChunksAreSeen() {
        const Bytes content = someContent(2 * kChunkBytes);
        ContentAssembly assembly = assemblyOf(content);
        for (const std::uint32_t index : {0u, 1u}) {
            Chunk swapped = packChunk(assembly.content(), content, 1 - index);
            swapped.index = index;
            QVERIFY(assembly.add(swapped));
        }
        QVERIFY(!assembly.finish());
    }

    void memoryIsWipedWhenItGoes() {
        const Bytes content = someContent(kChunkBytes + 5000);
        const Hash hash = contentHash(kKey, content);
        for (const std::size_t place : {std::size_t(100), content.size() - 100})
            for (const int chunks : {1, 2}) {
                std::vector<Chunk> packed;
                for (std::uint32_t index : {0u, 1u})
                    packed.push_back(packChunk(hash, content, index));
                test::watched.leaks = 0;
                {
                    ContentAssembly assembly(kKey, hash, content.size());
                    for (int index = 0; index < chunks; ++index)
                        QVERIFY(assembly.add(packed[std::size_t(index)]));
                    const ContentAssembly moved = std::move(assembly);
                    test::watched.secret = content.data() + place;
                }
                test::watched.secret = nullptr;
                QCOMPARE(test::watched.leaks.load(), 0);
            }
    }

    void memoryThatCannotBeHadIsAnError() {
        const Bytes content = someContent(kChunkBytes);
        ContentAssembly assembly(kKey, {}, std::uint64_t(1) << 63);
        const auto added = assembly.add(packChunk({}, content, 0));
        QVERIFY(!added && added.error().kind == ErrorKind::memory);
        QVERIFY(assembly.bytes().empty());
    }
};

QTEST_APPLESS_MAIN(ContentTest)
#include "content_test.moc"
