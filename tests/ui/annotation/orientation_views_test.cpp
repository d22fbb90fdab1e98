/// Letters and cube compared with the rendered view: a patient with one side marked, stored along any axes and seen
/// from any direction.

#include <QImage>
#include <QPainter>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include "render/prepare/flatten.h"
#include "render/prepare/layers_under.h"
#include "render/scene/orbit.h"
#include "render/scene/scene.h"
#include "tests/support/scenes/axis_views.h"
#include "tests/support/scenes/stored_ways.h"
#include "ui/annotation/orientation_cube.h"
#include "ui/annotation/orientation_letters.h"

namespace pdr::ui {
namespace {

using test::kSides;
using test::Side;

std::vector<Camera> axisViews(Camera::Type type) {
    return test::axisViews(type, 10, 105);
}

/// Returns a volume of air with a cube at that side of the patient, who is centred at the origin.
std::shared_ptr<const Volume> markedAt(const Side& side, const dmat3& axesOfVoxels) {
    constexpr int kEdge = 9;
    constexpr double kSpacing = 10;
    VolumeGeometry geometry;
    geometry.size = ivec3(kEdge);
    geometry.patientFromIndex = dmat4(kSpacing * axesOfVoxels);
    geometry.patientFromIndex[3] = dvec4(-kSpacing * axesOfVoxels * dvec3(kEdge / 2), 1);
    Voxels voxels;
    for (int k = 0; k < kEdge; ++k)
        for (int j = 0; j < kEdge; ++j)
            for (int i = 0; i < kEdge; ++i) {
                const dvec3 place(geometry.patientFromIndex * dvec4(i, j, k, 1));
                const bool marked = glm::length(place - 30.0 * side.way) < 18;
                voxels.push_back(marked ? 1000 : -1000);
            }
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

/// Returns the letter at the edge towards which the mark is seen; "." if it is in the middle, " " if it is not seen.
std::string seenAt(const std::shared_ptr<const Volume>& volume, const Camera& camera) {
    constexpr int kFilm = 31, kMiddle = kFilm / 2, kOut = 9;
    Scene scene;
    scene.volume = volume;
    scene.transferFunction = {1, {{0, 0}, {100, 1}}};
    scene.camera = camera;
    scene.film = ivec2(kFilm);
    const auto prepared = Flattener().prepare(scene);
    const EdgeLetters letters = edgeLetters(camera);
    const auto seen = [&](int x, int y) {
        return layersUnder(*prepared, vec2(kMiddle + x, kMiddle + y) + 0.5f).seen == SeenAt::place;
    };
    std::string found;
    for (const auto& [letter, x, y] :
         {std::tuple(letters.left, -kOut, 0), std::tuple(letters.right, kOut, 0), std::tuple(letters.top, 0, -kOut),
          std::tuple(letters.bottom, 0, kOut), std::tuple(std::string("."), 0, 0)})
        if (seen(x, y))
            found += letter;
    return found.empty() ? " " : found;
}

QImage painted(const std::function<void(QPainter&)>& paint) {
    QImage image(96, 96, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    paint(painter);
    return image;
}

/// Returns a square with a letter, painted by other means than the cube's.
QImage faceWith(char letter, int quarterTurns, bool mirrored) {
    return painted([&](QPainter& painter) {
        constexpr double kHalfFace = 48 / 1.7321;
        painter.setRenderHint(QPainter::Antialiasing);
        painter.translate(48, 48);
        painter.rotate(90 * quarterTurns);
        painter.scale(kHalfFace / 100 * (mirrored ? -1 : 1), kHalfFace / 100);
        painter.fillRect(QRectF(-100, -100, 200, 200), QColor(86, 86, 91));
        QFont font = painter.font();
        font.setPixelSize(120);
        font.setBold(true);
        painter.setFont(font);
        painter.setPen(QColor(235, 235, 235));
        painter.drawText(QRectF(-100, -100, 200, 200), Qt::AlignCenter, QString(QChar(letter)));
    });
}

long difference(const QImage& a, const QImage& b) {
    long sum = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            sum += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y)));
    return sum;
}

}  // namespace

class TestOrientationViews : public QObject {
    Q_OBJECT

  private slots:
    void theMarkedSideIsWhereItsLetterIs();
    void obliqueViewsNameTheStrongerSideFirst();
    void lettersAreThoseOfTheViewWhateverTheLens();
    void theCubeShowsTheSideThatOneLooksAt();
};

/// Tests every storage order of the scan and each of the 24 views along axes; each letter is tested in each.
void TestOrientationViews::theMarkedSideIsWhereItsLetterIs() {
    const auto orientations = test::signedPermutations();
    QCOMPARE(orientations.size(), std::size_t(48));
    const std::array views{axisViews(Camera::Type::perspective), axisViews(Camera::Type::orthographic)};
    QCOMPARE(views[0].size(), std::size_t(24));
    std::size_t atEdges = 0;
    for (std::size_t i = 0; i < orientations.size(); ++i)
        for (std::size_t s = 0; s < kSides.size(); ++s) {
            const auto volume = markedAt(kSides[s], orientations[i]);
            for (std::size_t v = (i + s) % 4; v < 24; v += 4) {
                const Camera& camera = views[(i + v) % 2][v];
                const bool across = std::abs(glm::dot(camera.forward(), kSides[s].way)) < 0.5;
                QCOMPARE(seenAt(volume, camera), across ? std::string(1, kSides[s].letter) : std::string("."));
                atEdges += across;
            }
        }
    QVERIFY(atEdges > 1000);
}

/// Letters are named as in DICOM viewers: a tilt of less than 10 degrees towards a side is not named.
void TestOrientationViews::obliqueViewsNameTheStrongerSideFirst() {
    const auto tilted = [](double degrees) {
        const double angle = glm::radians(degrees);
        return orientationLetters({std::sin(angle), -std::cos(angle), 0});
    };
    QCOMPARE(tilted(9.9), std::string("A"));
    QCOMPARE(tilted(10.1), std::string("AL"));
    QCOMPARE(tilted(44.9), std::string("AL"));
    QCOMPARE(tilted(45.1), std::string("LA"));
    QCOMPARE(tilted(80.1), std::string("L"));
    QCOMPARE(orientationLetters({0.5, -0.8, 0.3}), std::string("ALH"));
    QCOMPARE(orientationLetters({-1, 1.01, -1.02}), std::string("FPR"));
}

void TestOrientationViews::lettersAreThoseOfTheViewWhateverTheLens() {
    Camera camera = standardView(StandardView::anterior, dvec3(0), 100, 1);
    for (int i = 0; i < 50; ++i) {
        camera = orbited(camera, {0.07, 0.04});
        Camera flat = camera;
        flat.type = Camera::Type::orthographic;
        const EdgeLetters a = edgeLetters(camera), b = edgeLetters(flat);
        QVERIFY(a.left == b.left && a.right == b.right && a.top == b.top && a.bottom == b.bottom);
        QCOMPARE(a.right, orientationLetters(camera.right()));
    }
}

/// No other letter, turned or mirrored, is more like the painted one.
void TestOrientationViews::theCubeShowsTheSideThatOneLooksAt() {
    for (const Camera& camera : axisViews(Camera::Type::perspective)) {
        const QImage cube = painted([&](QPainter& p) { paintOrientationCube(p, QRectF(0, 0, 96, 96), camera); });
        const std::string facing = orientationLetters(-camera.forward());
        long rightOne = std::numeric_limits<long>::max(), nearest = rightOne;
        for (const Side& side : kSides)
            for (int turns = 0; turns < 4; ++turns)
                for (const bool mirrored : {false, true}) {
                    const long found = difference(cube, faceWith(side.letter, turns, mirrored));
                    nearest = std::min(nearest, found);
                    if (side.letter == facing[0] && !mirrored)
                        rightOne = std::min(rightOne, found);
                }
        QCOMPARE(facing.size(), std::size_t(1));
        QVERIFY2(rightOne <= nearest, facing.c_str());
    }
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestOrientationViews)
#include "orientation_views_test.moc"
