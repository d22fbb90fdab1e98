/// Tissue that is cut away is neither visible nor casts shadows, unless its shadow is requested.

#include <QTest>

#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

constexpr int kComparisons = 10;

/// Returns a slab, 10 mm thick, 2 mm of depth 1 each; the camera looks down -z from above, light comes the same way.
Scene cutSlab(double keepBelow, bool shadows) {
    Scene scene = test::slab(5, {0, 0, -1}, 0.8f);
    scene.clip.planes = {{{0, 0, keepBelow}, {0, 0, 1}}};
    scene.clip.shadows = shadows;
    return scene;
}

double backScattered(double tau) {
    return 0.8 / (4 * M_PI) * 2 * 0.5 * -std::expm1(-2 * tau);
}

Scene bumpy() {
    Scene scene = test::plainScene(test::bumpyVolume({40, 30, 30}, {1, 1.5, 2}, 7), 0.3f);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
    return scene;
}

}  // namespace

class ClipTest : public QObject {
    Q_OBJECT

  private slots:
    void cutTissueIsNeitherSeenNorThrowsAShadow() {
        const Film film = test::render(cutSlab(4, false), 8192);
        QVERIFY(std::fabs(test::z(film, backScattered(2))) < test::allowedZ(kComparisons));
    }

    void theShadowOfCutTissueCanBeKept() {
        const Film film = test::render(cutSlab(4, true), 8192);
        QVERIFY(std::fabs(test::z(film, backScattered(2) * std::exp(-3))) < test::allowedZ(kComparisons));
    }

    void nothingIsLeftWhenAllIsCut() {
        Scene scene = cutSlab(-1, false);
        scene.environment = {vec3(0.25f), true};
        const Film film = test::render(scene, 16);
        QCOMPARE(film.pixel(1, 2).mean.x, 0.25);
    }

    void everySideOfABoxCuts() {
        const Clip clip{ClipBox{{1, 2, 3}, {4, 6, 8}}, {}, false};
        const auto kept = [&](dvec3 place) {
            return std::ranges::all_of(clip.allPlanes(), [&](const ClipPlane& plane) {
                return glm::dot(place - plane.pointMm, plane.normal) <= 0;
            });
        };
        QVERIFY(kept({1.1, 2.1, 3.1}) && kept({3.9, 5.9, 7.9}));
        for (const dvec3 outside : {dvec3(0.9, 4, 5), dvec3(4.1, 4, 5), dvec3(2, 1.9, 5), dvec3(2, 6.1, 5),
                                    dvec3(2, 4, 2.9), dvec3(2, 4, 8.1)})
            QVERIFY(!kept(outside));
    }

    void boxOfTheWholeVolumeChangesNoBit() {
        Scene scene = bumpy();
        const Film without = test::render(scene, 64);
        scene.clip.box = ClipBox{dvec3(0), dvec3(40, 45, 60)};
        QVERIFY(test::sameBits(without, test::render(scene, 64)));
    }

    /// A cut that leaves a part of the volume shows what a volume of that part alone shows. The cut runs through voxel
    /// centres, where the smaller volume's border would clamp; tissue is even across it.
    void whatIsLeftLooksLikeAVolumeOfItsOwn() {
        const auto hu = [](int i, int j, int) { return 200 + 90 * std::sin(0.4 * i) + 70 * std::cos(0.5 * j); };
        Scene whole = test::plainScene(test::makeVolume({30, 30, 30}, dvec3(1), hu), 0.4f);
        whole.transferFunction.nodes = {{.hu = 100, .opacity = 0}, {.hu = 400, .opacity = 1}};
        whole.lights = {DirectionalLight{{1, 2, -2}, vec3(1)}};
        Scene half = whole;
        half.volume = test::makeVolume({30, 30, 20}, dvec3(1), hu);
        whole.clip.planes = {{{0, 0, 20}, {0, 0, 1}}};
        const test::ImageMean a = test::imageMean(test::render(whole, 512)),
                              b = test::imageMean(test::render(half, 512));
        QVERIFY(std::fabs(a.mean - b.mean) <
                test::allowedZ(kComparisons) * std::hypot(a.standardError, b.standardError));
        QVERIFY(a.standardError < 0.005 * a.mean);
    }

    /// A box turned by 45 degrees out of six oblique planes is the clip box of the volume turned the other way.
    void obliquePlanesCutWhereTheyAreSaidTo() {
        Scene scene = test::slab(5, {0, 0, -1}, 0.8f);
        // Above the middle of the image a plane of 45 degrees leaves 4 mm, 2.83 of them along its normal.
        scene.clip.planes = {{{200.5, 200.5, 4}, {1, 0, 1}}};
        scene.camera.heightMm = 1e-3;
        const double tau = 2, slant = 1;  // light and view both come straight down
        const Film film = test::render(scene, 8192);
        QVERIFY(std::fabs(test::z(film, backScattered(tau * slant))) < test::allowedZ(kComparisons));
    }

    void severalBouncesStayInWhatIsLeft() {
        Scene scene = cutSlab(4, false);
        scene.model = Model::multipleScattering;
        Scene thin = test::slab(2, {0, 0, -1}, 0.8f);
        thin.model = Model::multipleScattering;
        const test::ImageMean a = test::imageMean(test::render(scene, 8192)),
                              b = test::imageMean(test::render(thin, 8192));
        QVERIFY(std::fabs(a.mean - b.mean) <
                test::allowedZ(kComparisons) * std::hypot(a.standardError, b.standardError));
    }
};

QTEST_GUILESS_MAIN(ClipTest)
#include "clip_test.moc"
