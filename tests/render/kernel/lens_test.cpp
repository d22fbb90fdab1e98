/// The thin lens: what is sharp, what is not, and that nothing is lost beside it.

#include <QTest>

#include "render/kernel/transport/integrator.h"
#include "render/prepare/layers_under.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

Scene blob() {
    Scene scene = test::plainScene(test::bumpyVolume({40, 30, 30}, {1, 1.5, 2}, 7), 2);
    scene.transferFunction.nodes = {{.hu = -100, .opacity = 0}, {.hu = 300, .opacity = 1}};
    scene.lights = {DirectionalLight{{0, 1, -0.3}, vec3(1)}};
    scene.camera.apertureMm = 15;
    return scene;
}

}  // namespace

class LensTest : public QObject {
    Q_OBJECT

  private slots:
    /// Rays through all points of the lens meet where the pinhole's ray meets the plane of focus, in every corner.
    void sharpSurfaceIsAPlane_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<double>("focus");
        for (const double focus : {30.0, 200.0, 1000.0}) {
            QTest::addRow("perspective, %g mm", focus) << int(Camera::Type::perspective) << focus;
            QTest::addRow("orthographic, %g mm", focus) << int(Camera::Type::orthographic) << focus;
        }
    }
    void sharpSurfaceIsAPlane() {
        QFETCH(int, type);
        QFETCH(double, focus);
        Scene scene = blob();
        scene.camera.type = Camera::Type(type);
        scene.camera.focusMm = focus;
        scene.camera.heightMm = 100;
        scene.camera.apertureMm = 20;
        const auto prepared = test::prepared(scene);
        const FlatScene& flat = prepared->flat;
        // The volume is entered somewhere else by each ray, but all of them pass the same point at depth `focus`.
        const auto atFocus = [&](vec2 place, vec2 lens) {
            const PathSegment segment = generateCameraRay(flat, place, lens, vec2(0, 1e30f));
            const dvec3 local = dvec3(localPosition(flat.volume, segment.ray.origin));
            const double depth = glm::dot(local - flat.camera.localEye, flat.camera.forward);
            return local + dvec3(segment.direction) *
                               ((focus - depth) / glm::dot(dvec3(segment.direction), flat.camera.forward));
        };
        int seen = 0;
        for (const vec2 place : {vec2(16, 16), vec2(9, 12), vec2(22, 20)})
            for (const vec2 lens : {vec2(1, 0), vec2(-0.6f, 0.8f), vec2(0, -1)}) {
                if (generateCameraRay(flat, place, lens, vec2(0, 1e30f)).ray.length < 0 ||
                    generateCameraRay(flat, place, vec2(0), vec2(0, 1e30f)).ray.length < 0)
                    continue;
                QVERIFY(glm::length(atFocus(place, lens) - atFocus(place, vec2(0))) < 2e-3);
                ++seen;
            }
        QVERIFY(seen >= 3);
    }

    /// 16 rings of equal area times 16 sectors are equally likely, and the moments are those of a disc.
    void pointsOfTheLensAreUniform() {
        std::vector<double> bins(256);
        test::Sample x, y, xx, yy, xy;
        RandomStream random = Random(3, 1, 0).stream(Dimension::lens);
        for (int i = 0; i < 1 << 20; ++i) {
            const dvec2 p(sampleUniformDisk(random.pair()));
            const int ring = std::min(15, int(16 * glm::dot(p, p)));
            const double turn = std::atan2(p.y, p.x) / (2 * M_PI) + 0.5;
            ++bins[std::size_t(16 * ring + std::min(15, int(16 * turn)))];
            x.add(p.x), y.add(p.y), xx.add(p.x * p.x), yy.add(p.y * p.y), xy.add(p.x * p.y);
        }
        QVERIFY2(test::uniformP(bins) > 1e-6, qPrintable(QString::number(test::uniformP(bins))));
        const double allowed = test::allowedZ(5);
        QVERIFY(std::fabs(x.z(0)) < allowed && std::fabs(y.z(0)) < allowed && std::fabs(xy.z(0)) < allowed);
        QVERIFY(std::fabs(xx.z(0.25)) < allowed && std::fabs(yy.z(0.25)) < allowed);
    }

    /// A small bright square far out of focus, with nothing else there: its image is a disc, everywhere as bright,
    /// and holds all of its light.
    void blurOfASpotIsAnEvenDisc() {
        const double blur = 10, side = 2;  // mm at the square
        Scene scene = test::plainScene(test::makeVolume({4, 4, 4}, dvec3(1), [](int, int, int) { return 0; }), 1);
        scene.transferFunction.nodes[0].opacity = 0;
        scene.lights = {RectangleLight{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, side, side, vec3(1), true}};
        scene.camera = {.type = Camera::Type::orthographic,
                        .eyeMm = {0, 0, 500},
                        .targetMm = {0, 0, 0},
                        .up = {0, 1, 0},
                        .heightMm = 24,
                        .apertureMm = 4 * blur,
                        .focusMm = 1000};  // half of the lens' width is left at the square
        scene.film = {24, 24};
        const std::uint64_t samples = 8192;
        const Film film = test::render(scene, samples);
        const double fraction = side * side / (M_PI * blur * blur), expected = fraction * samples;
        double square = 0;
        int inside = 0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                const double away = glm::length(dvec2(x, y) - 11.5);
                if (away > blur - 0.75 * (side + 1))
                    continue;
                const double seen = film.pixel(x, y).mean.x * samples;
                square += (seen - expected) * (seen - expected) / (expected * (1 - fraction));
                ++inside;
            }
        QVERIFY(inside > 150);
        const double p = test::chiSquareP(square, inside);
        QVERIFY2(p > 1e-6, qPrintable(QString("%1 on %2").arg(square).arg(inside)));
        const test::ImageMean whole = test::imageMean(film);
        const double truth = side * side / (24 * 24);
        QVERIFY2(std::fabs(whole.mean - truth) < test::allowedZ(1) * whole.standardError,
                 qPrintable(QString("%1 +- %2, expected %3").arg(whole.mean).arg(whole.standardError).arg(truth)));
        QVERIFY(whole.standardError < 0.01 * truth);
    }

    /// Bounds of the view make room for what a lens spreads: with and without them it is the same image.
    void nothingIsLostBesideTheFocus() {
        for (const double focus : {30.0, 120.0, 1000.0}) {
            Scene scene = blob();
            scene.camera.focusMm = focus;
            const auto device = makeCpuDevice();
            const Film bounded = test::render(scene, 1024, *device);
            const auto open = test::prepared(scene);
            open->viewDepths.assign(open->viewDepths.size(), vec2(0, 1e30f));
            const test::ImageMean a = test::imageMean(bounded), b = test::imageMean(test::sampled(open, 1024));
            QVERIFY2(std::fabs(a.mean - b.mean) < 4.5 * std::hypot(a.standardError, b.standardError),
                     qPrintable(QString("focus %1: %2 and %3").arg(focus).arg(a.mean).arg(b.mean)));
            QVERIFY2(a.standardError < 0.01 * a.mean, qPrintable(QString("%1 +- %2").arg(a.mean).arg(a.standardError)));
        }
    }

    void whatIsUnderAPixelHasItsDepth() {
        Scene scene = test::slab(1e6, {0, 0, -1}, 0.8f);  // opaque, its face at z = 10, the eye at z = 500
        scene.film = {8, 8};
        const LayersUnder under = layersUnder(*test::prepared(scene), {3.5f, 5.5f});
        QVERIFY(under.seen == SeenAt::place && std::fabs(under.layers[0].depthMm - 490) < 0.1);
        scene.camera.eyeMm.x += 1000;
        scene.camera.targetMm.x += 1000;
        QVERIFY(layersUnder(*test::prepared(scene), {3.5f, 5.5f}).seen == SeenAt::nothing);
    }
};

QTEST_GUILESS_MAIN(LensTest)
#include "lens_test.moc"
