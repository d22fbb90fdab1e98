/// A head that was scanned with a tilted gantry: the image of its voxels on their sheared grid, against that of the
/// same voxels resampled on an upright grid, and that of the head itself. In levels of the display, from 0 to 255.

#include <QTest>

#include <cmath>

#include "render/film/display/tone_map.h"
#include "render/measure/trilinear.h"
#include "render/scene/fit_view.h"
#include "render/volume/sheared.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr double kPixelMm = 1.5, kTableMm = 2, kTiltDegrees = 18.5;
constexpr std::uint64_t kSamples = 256;

/// Returns 0 to 1 across a border that lies where `mm` is 0 and is as wide as a scanner blurs it.
double inside(double mm) {
    constexpr double kBlurMm = 1.2;
    return 0.5 * std::erfc(mm / (std::sqrt(2.0) * kBlurMm));
}

/// Returns the HU of a head about the origin: skin, a skull of uneven thickness with an opening at the front, and
/// brain. Borders are blurred, as in any scan.
double headHu(dvec3 mm) {
    const double r = glm::length(mm / dvec3(0.8, 1.0, 0.9)), around = std::atan2(mm.y, mm.x);
    const double outer = 50 + 1.5 * std::sin(5 * around) * std::sin(mm.z / 12), inner = outer - 7;
    const double opening = inside(glm::length(dvec2(mm.x - 6, mm.z + 4)) - 12) * inside(mm.y);
    const double tissue = -1000 + 1040 * inside(r - 58);
    const double bone = 1160 * (inside(r - outer) - inside(r - inner)) * (1 - opening);
    return tissue + bone;
}

template <class HuAt>
std::shared_ptr<const Volume> sampled(const VolumeGeometry& geometry, HuAt huAt) {
    Voxels voxels;
    voxels.reserve(geometry.voxelCount());
    for (int k = 0; k < geometry.size.z; ++k)
        for (int j = 0; j < geometry.size.y; ++j)
            for (int i = 0; i < geometry.size.x; ++i)
                voxels.push_back(std::int16_t(std::lround(huAt(dvec3(geometry.patientFromIndex * dvec4(i, j, k, 1))))));
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

VolumeGeometry centred(VolumeGeometry geometry) {
    geometry.patientFromIndex[3] -= dvec4(geometry.centreMm(), 0);
    return geometry;
}

VolumeGeometry upright(ivec3 size, dvec3 spacingMm) {
    return centred(VolumeGeometry::aligned(size, spacingMm, dvec3(0)));
}

/// The table moves along the patient, and each slice is turned about the ears.
VolumeGeometry tilted() {
    const double tilt = glm::radians(kTiltDegrees);
    VolumeGeometry geometry = upright({84, 96, 76}, {kPixelMm, kPixelMm, kTableMm});
    geometry.patientFromIndex[1] = kPixelMm * dvec4(0, std::cos(tilt), -std::sin(tilt), 0);
    return centred(geometry);
}

/// Returns the grid as if slices lay upright above each other, as programs that ignore the drift read it.
VolumeGeometry withoutDrift(VolumeGeometry geometry) {
    const dvec3 normal =
        glm::normalize(glm::cross(dvec3(geometry.patientFromIndex[0]), dvec3(geometry.patientFromIndex[1])));
    geometry.patientFromIndex[2] = dvec4(normal * sliceDrift(geometry).gapMm, 0);
    return centred(geometry);
}

std::vector<std::uint8_t> imageOf(std::shared_ptr<const Volume> volume, std::uint64_t seed = 1) {
    Scene scene = test::plainScene(std::move(volume), 3);
    scene.transferFunction.nodes = {{.hu = 250, .opacity = 0, .albedo = vec3(0.8f, 0.6f, 0.5f)},
                                    {.hu = 700, .opacity = 1, .albedo = vec3(0.9f), .specular = vec3(0.03f)}};
    scene.gradientFactor = 1;
    scene.lights = {DirectionalLight{glm::normalize(dvec3(0.4, 1, -0.7)), vec3(2.5)}};
    scene.environment.radiance = vec3(0.25f);
    scene.camera = standardView(StandardView::anterior, dvec3(0), 75, 1);
    scene.film = {96, 96};
    scene.seed = seed;
    return toneMap(test::render(scene, kSamples), Display{});
}

/// Returns the mean difference of the levels of two images.
double difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(int(a[i]) - int(b[i]));
    return sum / (0.75 * double(a.size()));  // alpha is the same in both
}

}  // namespace

class TiltedHeadTest : public QObject {
    Q_OBJECT

  private slots:
    /// Resampling blurs a little, and so the images need not be one. They are far closer to each other than to what is
    /// seen if the drift is ignored, or runs the other way.
    void theShearedGridShowsTheHeadAsItsResamplingDoes() {
        const auto sheared = sampled(tilted(), headHu);
        const measure::GridPlace grid(sheared->geometry());
        const auto resampled = sampled(upright({84, 92, 84}, {kPixelMm, kPixelMm, kPixelMm}), [&](dvec3 mm) {
            return grid.contains(mm) ? measure::huAt(*sheared, grid, mm) : -1000.0;
        });
        VolumeGeometry opposite = tilted();
        const dvec3 column = glm::normalize(dvec3(opposite.patientFromIndex[1]));
        opposite.patientFromIndex[2] -= dvec4(2 * glm::dot(dvec3(opposite.patientFromIndex[2]), column) * column, 0);
        const Voxels voxels(sheared->voxels().begin(), sheared->voxels().end());
        const auto image = imageOf(sheared), truth = imageOf(sampled(upright({168, 184, 168}, dvec3(0.75)), headHu));
        const double noise = difference(image, imageOf(sheared, 2)), apart = difference(image, imageOf(resampled));
        const double off = difference(image, truth), offResampled = difference(imageOf(resampled), truth);
        const double ignored =
            difference(imageOf(std::make_shared<const Volume>(withoutDrift(tilted()), voxels)), truth);
        const double mirrored = difference(imageOf(std::make_shared<const Volume>(centred(opposite), voxels)), truth);
        qInfo(
            "levels: noise %.2f, sheared to resampled %.2f, sheared to head %.2f, resampled to head %.2f, drift "
            "ignored "
            "%.2f, opposite %.2f",
            noise, apart, off, offResampled, ignored, mirrored);
        QVERIFY(apart < noise + 0.25 && off < 0.8 && off < offResampled);
        QVERIFY(ignored > 2 * off && mirrored > 4 * off);
    }
};

QTEST_APPLESS_MAIN(TiltedHeadTest)
#include "tilted_head_test.moc"
