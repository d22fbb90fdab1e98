/// Scenes of tissue, surfaces, lights and cuts against a quadrature of their own: see single_scattering.h. Seeds are
/// fixed; of 10,000 faultless runs one would fail (allowedZ over all comparisons). Every scene says which bias it finds
/// nine times out of ten, and must be able to.

#include <QTest>
#include <optional>

#include "tests/physics/hybrid_scenes.h"
#include "tests/physics/single_scattering.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

constexpr double kNineOfTen = 1.2816;  ///< a standard normal number stays below it nine times out of ten
constexpr double kQuadrature = 2e-4;   ///< relative: by how much the quadrature may be off

/// The scenes, on grids that are sheared by the environment variable PDR_TEST_SHEAR where it is set.
const std::vector<test::HybridScene>& scenes() {
    static const std::vector<test::HybridScene> all = [] {
        std::vector<test::HybridScene> made = test::hybridScenes();
        for (test::HybridScene& scene : made)
            scene.shear = qEnvironmentVariable("PDR_TEST_SHEAR", "0").toDouble();
        return made;
    }();
    return all;
}

/// The estimate of an image whose pixels all see the same ray.
struct RayEstimate {
    dvec3 mean{0}, standardError{0};
};

RayEstimate estimate(const Film& film) {
    RayEstimate sum;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x) {
            const PixelEstimate pixel = film.pixel(x, y);
            sum.mean += pixel.mean;
            sum.standardError += pixel.errorDraw * pixel.errorDraw;
        }
    const double pixels = double(film.size().x) * film.size().y;
    return {sum.mean / pixels, glm::sqrt(sum.standardError) / pixels};
}

dvec3 integral(const Scene& scene, test::written::Fineness fineness = {}) {
    return test::written::SingleScattering(scene, fineness).radiance(scene.camera.eyeMm, scene.camera.forward());
}

/// Returns the fine integral of the scene of that number. It is computed once, as two functions need it.
const dvec3& fineIntegral(std::size_t number) {
    static std::vector<std::optional<dvec3>> known(scenes().size());
    if (!known[number])
        known[number] = integral(scenes()[number].scene());
    return *known[number];
}

}  // namespace

class HybridTest : public QObject {
    Q_OBJECT

  private slots:
    void quadratureGivesTheClosedForm() {
        for (const double mu0 : {1.0, 0.8, 0.3}) {
            const Scene scene = test::slab(1.7, {std::sqrt(1 - mu0 * mu0), 1e-9, -mu0}, 0.8f);
            const double truth = 0.8 / (4 * M_PI) * 2 * mu0 / (1 + mu0) * -std::expm1(-1.7 * (1 + 1 / mu0));
            const Camera& camera = scene.camera;
            const dvec3 got = test::written::SingleScattering(scene).radiance(camera.eyeMm, {1e-9, 1e-9, -1});
            QVERIFY2(std::fabs(got.x / truth - 1) < 1e-6, qPrintable(QString::number(got.x / truth - 1)));
        }
    }

    void quadratureHasConverged() {
        for (std::size_t number = 0; number < scenes().size(); ++number) {
            const test::HybridScene& one = scenes()[number];
            const Scene scene = one.scene();
            const bool extended = one.room > 0 || !std::holds_alternative<DirectionalLight>(one.lights.front());
            if (!extended)
                continue;
            const dvec3 coarse = integral(scene, {8, 10}), &fine = fineIntegral(number);
            for (int c = 0; c < 3; ++c)
                QVERIFY2(std::fabs(coarse[c] / fine[c] - 1) < kQuadrature,
                         qPrintable(QString("%1: %2").arg(one.name.c_str()).arg(coarse[c] / fine[c] - 1)));
        }
    }

    void imageIsTheIntegral_data() {
        QTest::addColumn<int>("number");
        for (int i = 0; i < int(scenes().size()); ++i)
            QTest::newRow(scenes()[i].name.c_str()) << i;
    }
    void imageIsTheIntegral() {
        QFETCH(int, number);
        const test::HybridScene& one = scenes()[number];
        Scene scene = one.scene();
        scene.seed = std::uint64_t(number) + 1;
        const Result<void> accepted = scene.check();
        QVERIFY2(accepted, accepted ? "" : accepted.error().text().c_str());
        const RayEstimate got = estimate(test::render(scene, std::uint64_t(one.samples)));
        const dvec3& expected = fineIntegral(std::size_t(number));
        const double allowed = test::allowedZ(3 * int(scenes().size()));
        for (int c = 0; c < 3; ++c) {
            const double error = got.standardError[c], room = kQuadrature * expected[c];
            const double sees = ((allowed + kNineOfTen) * error + room) / expected[c];
            const double z = (got.mean[c] - expected[c]) / error;
            const QString found = QString("channel %1: %2 +- %3, expected %4: z %5, finds %6 %")
                                      .arg(c)
                                      .arg(got.mean[c])
                                      .arg(error)
                                      .arg(expected[c])
                                      .arg(z)
                                      .arg(100 * sees);
            QVERIFY2(std::fabs(got.mean[c] - expected[c]) <= allowed * error + room, qPrintable(found));
            QVERIFY2(sees <= one.sees, qPrintable(found));
        }
        deviations_.push_back((got.mean.y - expected.y) / got.standardError.y);
        together_ += (got.mean.y / expected.y - 1) / scenes().size();
        togetherVariance_ += std::pow(got.standardError.y / expected.y / scenes().size(), 2);
    }

    /// All scenes together find what each alone is too noisy for.
    void scenesDeviateByChanceOnly() {
        if (deviations_.size() != scenes().size())
            QSKIP("needs all scenes");
        double squares = 0;
        for (const double z : deviations_)
            squares += z * z;
        const double p = test::chiSquareP(squares, double(deviations_.size()));
        QVERIFY2(p > 1e-4 && p < 1 - 1e-4, qPrintable(QString("%1 on %2").arg(squares).arg(deviations_.size())));
        const double error = std::sqrt(togetherVariance_), allowed = test::allowedZ(1);
        QVERIFY2(std::fabs(together_) < allowed * error,
                 qPrintable(QString("mean deviation %1 +- %2").arg(together_).arg(error)));
        QVERIFY2((allowed + kNineOfTen) * error < 0.002, qPrintable(QString::number(error)));
    }

  private:
    std::vector<double> deviations_;  ///< deviations of the green channel, in standard errors
    double together_ = 0, togetherVariance_ = 0;
};

QTEST_GUILESS_MAIN(HybridTest)
#include "hybrid_test.moc"
