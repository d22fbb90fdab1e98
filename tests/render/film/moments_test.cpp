/// The error of a few samples, and luminance, by their definitions.

#include <QTest>

#include "render/film/moments.h"
#include "tests/support/scenes/one_pixel.h"

using namespace pdr;

class MomentsTest : public QObject {
    Q_OBJECT

  private slots:
    /// s / sqrt(n), s^2 the sum of squared deviations over n - 1.
    void errorOfAFewSamplesIsTheTextbooks() {
        const auto errorOf = [](std::vector<double> samples) {
            return test::filmOf(samples.size(), [&](std::uint64_t i) { return samples[std::size_t(i)]; })
                .pixel(0, 0)
                .standardError.x;
        };
        QVERIFY(std::fabs(errorOf({0, 1}) - 0.5) < 1e-12);
        QVERIFY(std::fabs(errorOf({1, 2, 4}) - std::sqrt(14.0 / 18)) < 1e-12);
        QVERIFY(std::fabs(errorOf({3, 1, 3, 1, 3, 1}) - std::sqrt(6.0 / 5 / 6)) < 1e-12);
    }

    /// Rec. 709.
    void luminanceOfThePrimaries() {
        QCOMPARE(luminance({1, 0, 0}), 0.2126);
        QCOMPARE(luminance({0, 1, 0}), 0.7152);
        QCOMPARE(luminance({0, 0, 1}), 0.0722);
        QVERIFY(std::fabs(luminance(dvec3(1)) - 1) < 1e-12);
    }
};

QTEST_GUILESS_MAIN(MomentsTest)
#include "moments_test.moc"
