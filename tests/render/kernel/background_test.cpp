/// A plain background is seen behind the volume and lights nothing of it.

#include <QTest>

#include <cmath>

#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

constexpr vec3 kBehind{0.25f, 0.5f, 2.0f};

/// A solid block in the middle of air, lit by a lamp and from all around.
Scene blockInAir(Model model) {
    Scene scene =
        test::plainScene(test::makeVolume({21, 21, 21}, dvec3(1),
                                          [](int i, int j, int k) {
                                              const ivec3 from(i - 10, j - 10, k - 10);
                                              return glm::all(glm::lessThan(glm::abs(from), ivec3(5))) ? 100 : -100;
                                          }),
                         50);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0, .albedo = vec3(0.9f)},
                                    {.hu = 50, .opacity = 1, .albedo = vec3(0.9f)}};
    scene.environment = {vec3(0.3f), false};
    scene.model = model;
    scene.maxBounces = 20;
    return scene;
}

Scene with(Scene scene, std::optional<vec3> background) {
    scene.background = background;
    return scene;
}

vec3 at(const Film& film, int x, int y) {
    return film.pixel(x, y).mean;
}

}  // namespace

class BackgroundTest : public QObject {
    Q_OBJECT

  private slots:
    void itIsSeenBesideAndNotOnWhatIsSolid_data() {
        QTest::addColumn<int>("model");
        QTest::addColumn<float>("tolerance");  // of a ray that is not followed to its end
        QTest::newRow("single scattering") << int(Model::singleScattering) << 1e-30f;
        QTest::newRow("multiple scattering") << int(Model::multipleScattering) << 1e-30f;
        QTest::newRow("emission and absorption") << int(Model::emissionAbsorption) << 1e-2f;
    }

    void itIsSeenBesideAndNotOnWhatIsSolid() {
        QFETCH(int, model);
        QFETCH(float, tolerance);
        const Scene scene = blockInAir(Model(model));
        const Film without = test::render(scene, 64), film = test::render(with(scene, kBehind), 64);
        QVERIFY(at(film, 0, 0) == kBehind && at(without, 0, 0) == vec3(0));
        QVERIFY(at(film, 16, 1) == kBehind);  // through the volume's air
        for (int y = 14; y < 18; ++y)
            for (int x = 14; x < 18; ++x)
                QVERIFY(glm::length(at(film, x, y) - at(without, x, y)) < tolerance && at(film, x, y) != vec3(0));
    }

    void theEnvironmentGivesWayToItAndGoesOnToLight() {
        Scene scene = blockInAir(Model::singleScattering);
        scene.environment.visible = true;
        QVERIFY(at(test::render(scene, 64), 0, 0) == vec3(0.3f));
        const Film film = test::render(with(scene, vec3(0)), 64);
        QVERIFY(at(film, 0, 0) == vec3(0));
        QVERIFY(at(film, 16, 16) == at(test::render(scene, 64), 16, 16));
    }

    void tissueLetsAsMuchOfItThroughAsOfLight() {
        Scene scene = test::slab(1.2, {0, 0, -1}, 0.5f);
        scene.model = Model::emissionAbsorption;
        const double seen =
            double(at(test::render(with(scene, kBehind), 64), 1, 1).z - at(test::render(scene, 64), 1, 1).z);
        QVERIFY2(std::abs(seen / (2 * std::exp(-1.2)) - 1) < 1e-2, qPrintable(QString::number(seen)));
    }

    /// Dark tissue before a light of 1000: a ray may not end where only tissue and environment have no more to add.
    void aBrightBackgroundIsSeenThroughDenseTissue() {
        constexpr double kDepth = 8, kBright = 1000;
        Scene scene = test::slab(kDepth, {0, 0, -1}, 0.01f);
        scene.volume = test::makeVolume({401, 401, 80}, {1, 1, 10. / 80}, [](int, int, int k) { return k % 5; });
        scene.model = Model::emissionAbsorption;
        const double seen = double(at(test::render(with(scene, vec3(float(kBright))), 64), 1, 1).z -
                                   at(test::render(scene, 64), 1, 1).z);
        QVERIFY2(std::abs(seen / (kBright * std::exp(-kDepth)) - 1) < 1e-2, qPrintable(QString::number(seen)));
    }

    void anXRayNeedsItsLightAndHounsfieldUnitsNone() {
        for (const Model model : {Model::absorption, Model::maximumIntensity}) {
            const Scene scene = blockInAir(model);
            QVERIFY(test::sameBits(test::render(scene, 64), test::render(with(scene, kBehind), 64)));
        }
    }
};

QTEST_GUILESS_MAIN(BackgroundTest)
#include "background_test.moc"
