/// Tests a coarse image shown through a guide: it has the guide's edges and the image's light, and neither the noise
/// nor the pixels of the image.

#include <tbb/global_control.h>
#include <QTest>
#include <cmath>
#include <functional>

#include "render/denoise/guided.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;
using denoise::Colours, denoise::Guide, denoise::Plane;

namespace {

constexpr ivec2 kCoarse{24, 16};
constexpr int kFiner = 4;

using Values = std::function<float(int x, int y)>;

void fill(Plane& plane, const Values& value) {
    for (int y = 0; y < plane.size().y; ++y)
        for (int x = 0; x < plane.size().x; ++x)
            plane.row(y)[x] = value(x, y);
    plane.mirror();
}

/// Returns a grey guide, seen straight on.
Guide guide(const Values& radiance, const Values& depth) {
    Guide made = denoise::guideOf(kCoarse, kFiner);
    for (Plane& plane : made.radiance)
        fill(plane, radiance);
    fill(made.normal[2], [&](int x, int y) { return radiance(x, y) > 0 ? 1.0f : 0.0f; });
    fill(made.depth, depth);
    fill(made.opacity, [&](int x, int y) { return radiance(x, y) > 0 ? 1.0f : 0.0f; });
    return made;
}

/// Returns the coarse image: each pixel is the mean of value() over its pixels of the guide.
Colours coarse(const Values& value) {
    Colours made = denoise::coloursOf(kCoarse);
    for (Plane& plane : made)
        fill(plane, [&](int x, int y) {
            float sum = 0;
            for (int i = 0; i < kFiner * kFiner; ++i)
                sum += value(kFiner * x + i % kFiner, kFiner * y + i / kFiner);
            return sum / (kFiner * kFiner);
        });
    return made;
}

float even(int, int) {
    return 0;
}
float one(int, int) {
    return 1;
}
float textured(int x, int y) {
    return float(0.2 + test::chance(1, std::size_t(y) * 1000 + std::size_t(x), 0));
}
/// Two surfaces, one far behind the other; the border lies within coarse pixels.
bool inFront(int x) {
    return x < 50;
}

}  // namespace

class GuidedTest : public QObject {
    Q_OBJECT

  private slots:
    void underEvenLightTheImageIsTheGuide() {
        const Colours out = guided(coarse([](int x, int y) { return 0.3f * textured(x, y); }), guide(textured, even));
        QVERIFY(out[0].size() == kFiner * kCoarse);
        for (int y = 0; y < kFiner * kCoarse.y; ++y)
            for (int x = 0; x < kFiner * kCoarse.x; ++x)
                QVERIFY(std::fabs(out[1].row(y)[x] / (0.3f * textured(x, y)) - 1) < 1e-4f);
    }

    void lightEndsWhereASurfaceEnds() {
        const auto light = [](int x, int) { return inFront(x) ? 1.0f : 0.1f; };
        const Colours out = guided(coarse(light), guide(one, [](int x, int) { return inFront(x) ? 5.0f : 50.0f; }));
        for (int x = 0; x < kFiner * kCoarse.x; ++x)
            QVERIFY2(std::fabs(out[0].row(30)[x] - light(x, 30)) < 0.15f, qPrintable(QString::number(x)));
    }

    void lightEndsWhereASurfaceTurns() {
        const auto light = [](int x, int) { return x < 48 ? 1.0f : 0.1f; };
        Guide turning = guide(one, even);
        fill(turning.normal[0], [](int x, int) { return x < 48 ? 0.0f : 1.0f; });
        fill(turning.normal[2], [](int x, int) { return x < 48 ? 1.0f : 0.0f; });
        const Colours out = guided(coarse(light), turning);
        for (int x = 0; x < kFiner * kCoarse.x; ++x)
            QVERIFY2(std::fabs(out[0].row(30)[x] - light(x, 30)) < 0.15f, qPrintable(QString::number(x)));
    }

    void lightThatChangesSlowlyStays() {
        const auto light = [](int x, int) { return 0.5f + 0.4f * std::sin(0.05f * float(x)); };
        const Colours out = guided(coarse(light), guide(one, even));
        for (int x = 0; x < kFiner * kCoarse.x; ++x)
            QVERIFY(std::fabs(out[0].row(30)[x] - light(x, 30)) < 0.1f);
    }

    void noiseGoes() {
        Colours noisy = coarse(one);
        for (Plane& plane : noisy)
            fill(plane, [](int x, int y) { return float(2 * test::chance(2, std::size_t(100 * y + x), 0)); });
        const Colours out = guided(noisy, guide(one, even));
        double squares = 0;
        for (int y = 0; y < kFiner * kCoarse.y; ++y)
            for (int x = 0; x < kFiner * kCoarse.x; ++x)
                squares += std::pow(out[0].row(y)[x] - 1, 2) / (kFiner * kFiner * kCoarse.x * kCoarse.y);
        QVERIFY2(std::sqrt(squares) < 0.3 * std::sqrt(1.0 / 3), qPrintable(QString::number(std::sqrt(squares))));
    }

    void whereTheGuideSeesNothingNothingIsShown() {
        const auto seen = [](int x, int) { return x < 50 ? 1.0f : 0.0f; };
        const Colours out = guided(coarse(one), guide(seen, even));
        for (int x = 0; x < kFiner * kCoarse.x; ++x)
            QVERIFY((out[0].row(30)[x] > 0) == (x < 50));
    }

    void threadsChangeNoBit() {
        const Colours lit = coarse(textured);
        const Guide on = guide(textured, textured);
        const auto with = [&](int threads) {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
            return guided(lit, on);
        };
        const Colours a = with(1), b = with(3);
        for (int y = 0; y < kFiner * kCoarse.y; ++y)
            QVERIFY(std::equal(a[2].row(y), a[2].row(y) + kFiner * kCoarse.x, b[2].row(y)));
    }
};

QTEST_GUILESS_MAIN(GuidedTest)
#include "guided_test.moc"
