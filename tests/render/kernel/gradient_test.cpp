/// The gradient of which surfaces are made: what it is exact for, that it has no kink anywhere, and that it finds the
/// truth between thick slices better than differences of the trilinear HU.

#include "render/kernel/gradient.h"

#include <QTest>

#include <random>

#include "render/kernel/volume_sampling.h"
#include "tests/physics/written_volume.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

std::shared_ptr<const PreparedScene> flat(std::shared_ptr<const Volume> volume) {
    return test::prepared(test::plainScene(std::move(volume), 1));
}

/// An oblique volume: turned about two axes, with slices thicker than its pixels are wide, and some rows not at right
/// angles.
template <class Value>
std::shared_ptr<const Volume> obliqueVolume(ivec3 size, Value&& value) {
    const std::shared_ptr<const Volume> upright = test::makeVolume(size, dvec3(1), value);
    VolumeGeometry geometry = upright->geometry();
    geometry.patientFromIndex[0] = {0.48, 0.6, 0, 0};
    geometry.patientFromIndex[1] = {-0.4, 0.32, 0.5, 0};
    geometry.patientFromIndex[2] = {0.9, -0.5, 1.9, 0};
    return std::make_shared<Volume>(geometry, Voxels(upright->voxels().begin(), upright->voxels().end()));
}

/// Returns an irregular HU from -1000 to 999: a hash of the voxel's index.
int rough(int i, int j, int k) {
    std::minstd_rand random(unsigned(1 + i + 64 * j + 4096 * k));
    random.discard(3);
    return int(random() % 2000) - 1000;
}

/// Returns the gradient by differences of the trilinear HU over a voxel to each side [HU/mm].
vec3 centralDifference(const FlatVolume& volume, vec3 place) {
    vec3 perIndex;
    for (int axis = 0; axis < 3; ++axis) {
        vec3 step(0);
        step[axis] = 1;
        perIndex[axis] =
            (interpolatedHounsfield(volume, place + step) - interpolatedHounsfield(volume, place - step)) / 2;
    }
    return glm::transpose(volume.indexFromLocal) * perIndex;
}

/// Returns for how many of the 7 x 7 x 7 points in a voxel around (x, y, z) `inside` holds, scaled to 1000 HU.
template <class Inside>
int partOf(dvec3 centre, dvec3 spacing, Inside&& inside) {
    int count = 0;
    for (int n = 0; n < 343; ++n)
        count += inside(centre + spacing * (dvec3(n % 7, n / 7 % 7, n / 49) - 3.0) / 7.0) ? 1 : 0;
    return int(std::lround(count / 0.343));
}

/// Returns the angle between a gradient and the direction in which the HU decrease [degrees].
double degreesOff(vec3 gradient, dvec3 outwards) {
    return glm::degrees(std::acos(std::clamp(-glm::dot(glm::normalize(dvec3(gradient)), outwards), -1.0, 1.0)));
}

struct Errors {
    double sum = 0, worst = 0;
    int count = 0;
    void add(double error) {
        sum += error * error;
        worst = std::max(worst, error);
        ++count;
    }
    double rms() const { return std::sqrt(sum / count); }
};

/// Returns the errors of the grey levels of a flat wall that is lit at 45 degrees, along its slope through four slices
/// of 3 mm; pixels are 0.7 mm.
template <class Gradient>
Errors levelsOffOnSlope(double degrees, Gradient&& gradient) {
    const dvec3 spacing(0.7, 0.7, 3);
    const double slope = glm::radians(degrees);
    const dvec3 normal(std::sin(slope), 0, std::cos(slope)), along(std::cos(slope), 0, -std::sin(slope));
    const dvec3 middle = spacing * dvec3(60, 4, 10) + dvec3(0.1, 0, 0.2);
    const auto prepared = flat(test::makeVolume({120, 9, 20}, spacing, [&](int i, int j, int k) {
        return partOf(spacing * dvec3(i, j, k), spacing, [&](dvec3 p) { return glm::dot(p - middle, normal) < 0; });
    }));
    const dvec3 toLight = glm::normalize(normal + along);
    Errors errors;
    for (double way = -6; way < 6; way += 0.05) {
        const vec3 place((middle + along * (way / std::sin(slope))) / spacing);
        const vec3 found = -glm::normalize(gradient(prepared->flat.volume, place));
        errors.add(255 * (glm::dot(dvec3(found), toLight) - glm::dot(normal, toLight)));
    }
    return errors;
}

}  // namespace

class GradientTest : public QObject {
    Q_OBJECT

  private slots:
    /// Checks a grid that is turned, sheared and of unequal spacing.
    void linearHuHaveTheirGradientEverywhere() {
        const auto volume = obliqueVolume({12, 11, 10}, [](int i, int j, int k) { return 70 * i - 130 * j + 250 * k; });
        const auto prepared = flat(volume);
        const dvec3 truth =
            glm::transpose(glm::inverse(dmat3(volume->geometry().patientFromIndex))) * dvec3(70, -130, 250);
        std::mt19937 random(3);
        std::uniform_real_distribution<float> share(0, 1);
        for (int n = 0; n < 500; ++n) {
            const vec3 place = 1.0f + vec3(share(random), share(random), share(random)) * vec3(9, 8, 7);
            const dvec3 found(hounsfieldGradient(prepared->flat.volume, place));
            QVERIFY2(glm::length(found - truth) < 1e-5 * glm::length(truth),
                     qPrintable(QString::number(glm::length(found - truth))));
        }
    }

    /// Compares with a second implementation in double precision, from the spline's other formula; on both sides of the
    /// borders, too.
    void itIsTheGradientOfTheCubicSpline() {
        const auto volume = obliqueVolume({7, 6, 5}, rough);
        const auto prepared = flat(volume);
        const test::written::Grid grid(*volume);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> share(0, 1);
        for (int n = 0; n < 2000; ++n) {
            const vec3 place = vec3(share(random), share(random), share(random)) * vec3(volume->size()) - 0.5f;
            const dvec3 truth = grid.gradient(dvec3(place)), found(hounsfieldGradient(prepared->flat.volume, place));
            QVERIFY2(glm::length(found - truth) < 2e-3,
                     qPrintable(QString("%1 of %2").arg(glm::length(found - truth)).arg(glm::length(truth))));
        }
    }

    /// Crosses planes of voxel centres along each axis: the jump falls with the step, and so does that of the slope,
    /// which for differences of the trilinear HU it does not.
    void voxelPlanesAreNeitherStepsNorKinks() {
        const auto prepared = flat(test::makeVolume({16, 16, 16}, {1, 1.3, 2.5}, rough));
        const FlatVolume& volume = prepared->flat.volume;
        const auto bend = [&](auto&& gradient, vec3 place, vec3 step) {
            return glm::length(gradient(volume, place + step) + gradient(volume, place - step) -
                               2.0f * gradient(volume, place)) /
                   glm::length(step);
        };
        for (int axis = 0; axis < 3; ++axis) {
            double jump[2] = {}, kink[2] = {}, oldKink[2] = {};
            for (int n = 0; n < 200; ++n) {
                vec3 place(3.3f + float(n % 7), 4.2f + float(n % 5), 2.6f + float(n % 9));
                place[axis] = std::round(place[axis]);
                for (const int fine : {0, 1}) {
                    vec3 step(0);
                    step[axis] = fine ? 1.0f / 128 : 1.0f / 16;
                    jump[fine] += glm::length(hounsfieldGradient(volume, place + step) -
                                              hounsfieldGradient(volume, place - step));
                    kink[fine] += bend(hounsfieldGradient, place, step);
                    oldKink[fine] += bend(centralDifference, place, step);
                }
            }
            QVERIFY2(jump[1] < 0.15 * jump[0], qPrintable(QString("%1 and %2").arg(jump[1]).arg(jump[0])));
            QVERIFY2(kink[1] < 0.15 * kink[0], qPrintable(QString("%1 and %2").arg(kink[1]).arg(kink[0])));
            QVERIFY(oldKink[1] > 0.8 * oldKink[0]);
        }
    }

    /// Beyond the borders the outermost voxels go on, bit by bit as if they were there.
    void bordersAreTheOutermostVoxelsRepeated() {
        const ivec3 size(4, 3, 5), padded = size + 6;
        const auto bare = flat(test::makeVolume(size, {1, 2, 3}, rough));
        const auto wide = flat(test::makeVolume(padded, {1, 2, 3}, [&](int i, int j, int k) {
            const ivec3 nearest = glm::clamp(ivec3(i, j, k) - 3, ivec3(0), size - 1);
            return rough(nearest.x, nearest.y, nearest.z);
        }));
        for (int n = 0; n < 9 * 7 * 11; ++n) {
            const vec3 place = vec3(n % 9, n / 9 % 7, n / 63) * 0.5f - 0.5f;
            QVERIFY(hounsfieldGradient(bare->flat.volume, place) ==
                    hounsfieldGradient(wide->flat.volume, place + 3.0f));
        }
    }

    /// The gradient is exactly zero where all voxels agree and along axes of one voxel. Otherwise the phase function
    /// would not apply there.
    void whereNothingChangesItIsExactlyZero() {
        for (const ivec3 size : {ivec3(1, 1, 1), ivec3(6, 1, 1), ivec3(1, 6, 6), ivec3(6, 6, 6)}) {
            const auto prepared = flat(test::makeVolume(size, {0.7, 1, 3}, [](int, int, int) { return 1237; }));
            for (float part = 0; part < 1; part += 0.03f)
                QVERIFY(hounsfieldGradient(prepared->flat.volume, vec3(part) * vec3(size) - 0.5f) == vec3(0));
        }
        const auto layers = flat(test::makeVolume({6, 6, 6}, dvec3(1), [](int, int, int k) { return rough(0, 0, k); }));
        for (float part = 0; part < 1; part += 0.03f) {
            const vec3 gradient = hounsfieldGradient(layers->flat.volume, {2.3f, 2.9f, 6 * part - 0.5f});
            QVERIFY(gradient.x == 0 && gradient.y == 0);
        }
    }

    /// A ball of 1000 HU in voxels that hold what part of them it fills: its normals are known.
    void normalsOfABallAreCloserToTheTruth() {
        for (const dvec3 spacing : {dvec3(1), dvec3(0.96, 0.96, 1.5), dvec3(0.7, 0.7, 3)}) {
            const ivec3 size(glm::ceil(36.0 / spacing));
            const dvec3 centre = spacing * (dvec3(size) - 1.0) / 2.0 + dvec3(0.1, 0.2, 0.3);
            const auto prepared = flat(test::makeVolume(size, spacing, [&](int i, int j, int k) {
                return partOf(spacing * dvec3(i, j, k), spacing, [&](dvec3 p) { return glm::length(p - centre) < 14; });
            }));
            Errors spline, differences;
            for (int n = 0; n < 4000; ++n) {
                const double height = (n + 0.5) / 2000 - 1, around = 2.39996323 * n;
                const dvec3 out(std::sqrt(1 - height * height) * dvec2(std::cos(around), std::sin(around)), height);
                const vec3 place((centre + 14.0 * out) / spacing);
                spline.add(degreesOff(hounsfieldGradient(prepared->flat.volume, place), out));
                differences.add(degreesOff(centralDifference(prepared->flat.volume, place), out));
            }
            const QString both = QString("%1 degrees rms, at most %2, with differences %3 and %4")
                                     .arg(spline.rms())
                                     .arg(spline.worst)
                                     .arg(differences.rms())
                                     .arg(differences.worst);
            qInfo("%s", qPrintable(both));
            QVERIFY2(spline.rms() < 0.7 * differences.rms() && spline.worst < 0.8 * differences.worst,
                     qPrintable(both));
        }
    }

    /// A flat wall has one grey, whatever slices it runs through.
    void aWallThroughThickSlicesIsShadedCloserToTheTruth() {
        for (const double degrees : {15.0, 25.0, 35.0, 50.0, 70.0}) {
            const double spline = levelsOffOnSlope(degrees, hounsfieldGradient).rms();
            const double differences = levelsOffOnSlope(degrees, centralDifference).rms();
            const QString both = QString("at %1 degrees off by %2 levels rms, with differences %3")
                                     .arg(degrees)
                                     .arg(spline)
                                     .arg(differences);
            qInfo("%s", qPrintable(both));
            QVERIFY2(spline < 20 && spline < 0.75 * differences, qPrintable(both));
        }
    }

    /// The normals are those of the voxels, whether or not a GPU filters the HU by texture.
    void aTextureChangesNoNormal() {
        const auto prepared = test::prepared(test::plainScene(test::makeVolume({8, 8, 8}, dvec3(1), rough), 1));
        const vec3 place(3.3f, 4.7f, 2.1f), exact = hounsfieldGradient(prepared->flat.volume, place);
        prepared->flat.volume.texture = 1;
        QVERIFY(hounsfieldGradient(prepared->flat.volume, place) == exact);
    }
};

QTEST_APPLESS_MAIN(GradientTest)
#include "gradient_test.moc"
