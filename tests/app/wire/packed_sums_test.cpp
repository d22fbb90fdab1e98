/// Sums come out of their pack as they went in, to the last bit, and nothing else comes out of anything.

#include "tests/support/scenes/scenes.h"

#include <QTest>

#include <random>

#include "app/wire/byte_planes.h"
#include "app/wire/one_frame.h"
#include "app/wire/packed_sums.h"
#include "render/volume/phantom.h"
#include "tests/app/wire/example_messages.h"
#include "tests/support/processor_time.h"

using namespace pdr;
using namespace pdr::wire;

namespace {

using Sums = std::vector<PixelSums>;

bool comesBack(const Sums& sums) {
    const Bytes packed = packSums(sums);
    const auto unpacked = unpackSums(packed, sums.size());
    return packed.size() <= packedSumsBound(sums.size()) && unpacked && test::sameSums(*unpacked, sums);
}

/// Any bits at all, in that part of the pixels; the others are alike.
Sums anySums(std::size_t pixels, double part, unsigned seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution own(part);
    Sums sums(pixels, {.evenCount = 32, .count = 64, .seen = 2});
    for (PixelSums& pixel : sums)
        if (own(random)) {
            std::array<std::uint32_t, sizeof pixel / 4> bits;
            std::ranges::generate(bits, random);
            std::memcpy(static_cast<void*>(&pixel), bits.data(), sizeof pixel);
        }
    return sums;
}

/// A skull, from the front, in nobody's surroundings.
Scene skull() {
    Scene scene = test::plainScene(std::make_shared<const Volume>(headPhantom({64, 58, 64}, {3.908, 5.6, 3.908})), 1);
    scene.transferFunction.nodes = {
        {.hu = 150, .opacity = 0},
        {.hu = 400, .opacity = 1, .albedo = vec3(0.93f, 0.86f, 0.7f), .specular = vec3(0.04f), .roughness = 0.4f}};
    scene.gradientFactor = 2;
    scene.environment.radiance = vec3(0.3f, 0.32f, 0.35f);
    scene.background = vec3(0);
    scene.film = {192, 192};
    return scene;
}

Sums rendered(const Scene& scene, const Tile& area, std::uint32_t samples) {
    const std::unique_ptr<Device> device = test::testedDevice();
    (void)device->upload(scene);
    return test::renderedPart(scene, area, samples, *device, samples)->content().block;
}

/// Returns the times per pixel: "12 ns to pack, 8 ns to unpack".
std::string timesOf(const Sums& sums) {
    constexpr int kTimes = 300;
    const auto nanoseconds = [&](auto&& work) {
        const test::ProcessorTime spent;
        for (int i = 0; i < kTimes; ++i)
            work();
        return std::to_string(int(1e9 * spent.seconds() / (kTimes * double(sums.size())))) + " ns";
    };
    const Bytes packed = packSums(sums);
    return nanoseconds([&] { (void)packSums(sums); }) + " to pack, " +
           nanoseconds([&] { (void)unpackSums(packed, sums.size()); }) + " to unpack";
}

}  // namespace

class PackedSumsTest : public QObject {
    Q_OBJECT

  private slots:
    void anythingComesBackToTheLastBit() {
        QVERIFY(packSums({}).empty());
        for (const std::size_t pixels : {0, 1, 2, 7, 8, 9, 63, 64, 65, 1000, 4096, 5000})
            for (const double part : {0.0, 0.01, 0.5, 1.0})
                QVERIFY(comesBack(anySums(pixels, part, unsigned(pixels))));
        QVERIFY(comesBack(anySums(kMostLeasePixels, 1, 3)));
    }

    void numbersThatAreNoneComeBack() {
        const double no = std::numeric_limits<double>::quiet_NaN(), endless = std::numeric_limits<double>::infinity(),
                     least = std::numeric_limits<double>::denorm_min();
        for (const double value : {no, -no, std::bit_cast<double>(0x7ff0000000000123), endless, -endless, -0.0, least})
            QVERIFY(comesBack({{}, {.sum = {value, 0, -0.0}, .evenSum = vec3(float(value), 0, 0)}, {}}));
    }

    void darkPixelsAreNearlyFree() {
        for (const PixelSums& dark : {PixelSums{}, PixelSums{.evenCount = 32, .count = 64, .seen = 3}}) {
            const Bytes packed = packSums(Sums(4096, dark));
            QVERIFY2(packed.size() < 100, qPrintable(QString::number(packed.size())));
        }
    }

    void boneImagesTakeFewBytes() {
        const Scene scene = skull();
        for (const std::uint32_t samples : {4, 24, 63}) {
            const Sums whole = rendered(scene, wholeImage(scene.film), samples);
            const Sums middle = rendered(scene, {64, 64, 64, 64}, samples);  // nearly nothing but bone
            QVERIFY(comesBack(whole) && comesBack(middle));
            const double bytes = double(packSums(whole).size()) / double(whole.size());
            const double bytesOfBone = double(packSums(middle).size()) / double(middle.size());
            qInfo("%u samples: %.1f bytes a pixel, %.1f of bone; of bone %s", samples, bytes, bytesOfBone,
                  timesOf(middle).c_str());
            QVERIFY(bytes > 1 && bytes < 20);
            QVERIFY(bytesOfBone > bytes && bytesOfBone < 46);
        }
    }

    void theReceiverKnowsHowManyPixels() {
        for (const std::size_t pixels : {1, 8, 15, 100}) {
            const Bytes packed = packSums(anySums(pixels, 0.5, 7));
            for (const std::size_t expected : {pixels - 1, pixels + 1, std::size_t(0), kMostLeasePixels})
                QVERIFY(!unpackSums(packed, expected));
            QVERIFY(!unpackSums({}, pixels));
        }
    }

    void whatIsTooShortOrTooLongIsRefused() {
        Bytes packed = packSums(test::unlikeSums(100));
        for (std::size_t end = 0; end < packed.size(); ++end)
            QVERIFY(!unpackSums(std::span(packed).first(end), 100));
        const Bytes twice = packedFrame(packed, {}, 1);
        QVERIFY(!unpackSums(twice, 100));
        packed.push_back({});
        QVERIFY(!unpackSums(packed, 100));
    }

    void bombsAreNotUnpacked() {
        const std::uint32_t head[2]{100, 100};
        const Bytes bomb = packedFrame(std::as_bytes(std::span(head)), Bytes(64 << 20), 1);
        QVERIFY(bomb.size() < 10000);
        QVERIFY(!unpackSums(bomb, 100));
    }

    void placesMustBeAsManyAsSaid() {
        const auto packedWith = [](std::uint32_t own, int places, std::size_t planes) {
            const std::uint32_t head[2]{5, own};
            Bytes raw(sizeof(PixelSums) + 1 + planes * sizeof(PixelSums));
            raw[sizeof(PixelSums)] = std::byte(places);
            return packedFrame(std::as_bytes(std::span(head)), raw, 1);
        };
        QVERIFY(unpackSums(packedWith(2, 0b10001, 8), 5));
        QVERIFY(!unpackSums(packedWith(2, 0b10011, 8), 5));
        QVERIFY(!unpackSums(packedWith(2, 0b10000, 8), 5));
        QVERIFY(!unpackSums(packedWith(2, 0b100001, 8), 5));  // beyond the last
        QVERIFY(!unpackSums(packedWith(6, 0b111111, 8), 5));
        QVERIFY(!unpackSums(packedWith(2, 0b10001, 16), 5));
    }

    /// A sound frame of 14 MB, of a few hundred bytes when packed, where 300 kB are at hand.
    void moreOwnPixelsThanThereAreAreRefused() {
        constexpr std::uint32_t kPixels = 256, kOwn = 200'000;
        const std::uint32_t head[2]{kPixels, kOwn};
        const Bytes raw(sizeof(PixelSums) + kPixels / 8 + kPlanes * planeBytes(kOwn), std::byte('A'));
        const Bytes packed = packedFrame(std::as_bytes(std::span(head)), raw, 1);
        QVERIFY(packed.size() < 2000);
        QVERIFY(!unpackSums(packed, kPixels));
    }

    void damagedPacksDoNoHarm() {
        std::mt19937 random(11);
        const Bytes packed = packSums(anySums(300, 0.3, 2));
        int refused = 0;
        for (int i = 0; i < 20000; ++i) {
            Bytes damaged = packed;
            for (unsigned n = random() % 4 + 1; n > 0; --n)
                damaged[random() % damaged.size()] = std::byte(random());
            const auto sums = unpackSums(damaged, 300);
            QVERIFY(!sums || sums->size() == 300);
            refused += !sums;
        }
        QVERIFY(refused > 0);
    }
};

QTEST_APPLESS_MAIN(PackedSumsTest)
#include "packed_sums_test.moc"
