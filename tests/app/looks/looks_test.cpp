/// The looks that the programs carry, in images: what they show and what they must not.

#include "tests/support/scenes/scenes.h"

#include <QColor>
#include <QTest>

#include <random>

#include "app/looks/looks.h"
#include "render/film/display/exposure.h"
#include "render/film/display/tone_map.h"
#include "render/film/display_transform.h"
#include "render/scene/fit_view.h"
#include "render/volume/coarser.h"
#include "render/volume/raw_file.h"
#include "tests/support/dicom/shared_data.h"

using namespace pdr;

namespace {

Scene frontOf(std::shared_ptr<const Volume> volume, const NamedLook& look, int pixels) {
    ImageSetup setup;
    setup.camera = fittedView(StandardView::anterior, {volume->geometry(), nullptr}, 1, 0.95);
    const VolumeGeometry box = volume->geometry();
    return sceneOf(withNamedLook(setup, look, box), std::move(volume), ivec2(pixels));
}

/// The scanned air of a CT, with its noise.
std::shared_ptr<const Volume> noisyAir() {
    std::mt19937 random(5);
    std::normal_distribution<double> noise(-1000, 25);
    return test::makeVolume({64, 64, 64}, dvec3(3), [&](int, int, int) { return std::max(-1024.0, noise(random)); });
}

std::shared_ptr<const Volume> cranium() {
    const std::filesystem::path file = std::filesystem::path(PDR_SOURCE_DIR) / "build/example/matrix.dat";
    auto head = loadRaw({file, RawFile::Type::int16, {256, 256, 108}, {0.9570312, 0.9570312, 1.5}, {}});
    return head ? std::make_shared<const Volume>(*std::move(head)) : nullptr;
}

const std::vector<NamedLook>& bundled() {
    static const std::vector<NamedLook> looks = *app::bundledLooks();
    return looks;
}

NamedLook lookNamed(const std::string& name) {
    for (const NamedLook& look : bundled())
        if (look.name == name)
            return look;
    return {};
}

QColor colourAt(const Film& film, const pdr::Display& display, int x, int y) {
    std::uint8_t levels[3];
    displayTransform(display).setLevels(film.pixel(x, y).mean, levels);
    return {levels[0], levels[1], levels[2]};
}

}  // namespace

class LooksTest : public QObject {
    Q_OBJECT

  private slots:
    void airIsNothing() {
        const auto air = noisyAir();
        for (const NamedLook& look : bundled()) {
            const Film film = test::render(frontOf(air, look, 48), 16);
            const QColor corner = colourAt(film, look.look.display, 0, 0);
            int seen = 0;
            for (int y = 0; y < 48; ++y)
                for (int x = 0; x < 48; ++x)
                    seen += std::abs(colourAt(film, look.look.display, x, y).green() - corner.green()) > 12;
            QVERIFY2(seen <= 48 * 48 / 100, (look.name + ": " + std::to_string(seen)).c_str());
        }
    }

    /// Bone is ivory: neither grey nor green.
    void theForeheadIsIvory() {
        const auto head = cranium();
        if (!head)
            PDR_SKIP_FOR_WANT_OF_DATA("the example's voxels are not there: ./bootstrap test unpacks them");
        // Its y runs to the front in the file, and to the back in the patient: the forehead is seen from the back.
        const NamedLook bone = lookNamed("Bone");
        Scene scene = frontOf(std::make_shared<const Volume>(coarser(*head, 2)), bone, 64);
        scene.camera = fittedView(StandardView::posterior, {head->geometry(), nullptr}, 1, 0.95);
        scene = withNamedLook(scene, bone, scene.volume->geometry());
        const Film film = test::render(scene, 64);
        std::vector<double> hues, saturations;
        for (int y = 17; y < 23; ++y)
            for (int x = 29; x < 36; ++x) {
                const QColor colour = colourAt(film, bone.look.display, x, y);
                hues.push_back(colour.hsvHueF() * 360);
                saturations.push_back(colour.hsvSaturationF());
            }
        std::ranges::sort(hues);
        std::ranges::sort(saturations);
        const double hue = hues[hues.size() / 2], saturation = saturations[saturations.size() / 2];
        qInfo("hue %.1f degrees, saturation %.2f", hue, saturation);
        QVERIFY(hue > 30 && hue < 45 && saturation > 0.35);
    }

    void everyScanHasALookToBeginWith() {
        const auto first = [](const segment::Findings& findings) {
            for (const NamedLook& look : bundled())
                if (whyUnsuited(look, findings).empty())
                    return look.name;
            return std::string();
        };
        QCOMPARE(first({}), std::string("Bone"));
        QCOMPARE(first({400, 3000, 5, 365.0f}), std::string("Bones alone"));
    }
};

QTEST_GUILESS_MAIN(LooksTest)
#include "looks_test.moc"
