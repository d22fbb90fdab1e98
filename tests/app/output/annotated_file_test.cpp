/// What stands in the files that leave the program: its letters are read back from their pixels and held against where
/// a mark in the patient is seen.

#include <QImage>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "app/output/image_writing.h"
#include "render/device/device_list.h"
#include "render/scene/scene.h"
#include "render/session/batch_render.h"
#include "tests/support/scenes/axis_views.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

using test::kSides;
using test::Side;

/// The edges of an image: to the right and downwards.
constexpr std::array<ivec2, 4> kEdges{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

std::vector<Camera> axisViews(Camera::Type type) {
    return test::axisViews(type, 14, 150);
}

/// Air but for a ball at that side of the patient, stored along mirrored axes where it is `mirrored`.
Scene markedAt(const Side& side, const Camera& camera, bool mirrored) {
    constexpr int kEdge = 11;
    constexpr double kSpacing = 8;
    const dmat3 axes = mirrored ? dmat3({0, -1, 0}, {1, 0, 0}, {0, 0, -1}) : dmat3(1);
    VolumeGeometry geometry;
    geometry.size = ivec3(kEdge);
    geometry.patientFromIndex = dmat4(kSpacing * axes);
    geometry.patientFromIndex[3] = dvec4(-kSpacing * axes * dvec3(kEdge / 2), 1);
    Voxels voxels;
    for (int k = 0; k < kEdge; ++k)
        for (int j = 0; j < kEdge; ++j)
            for (int i = 0; i < kEdge; ++i) {
                const dvec3 place(geometry.patientFromIndex * dvec4(i, j, k, 1));
                voxels.push_back(glm::length(place - 30.0 * side.way) < 13 ? 1000 : -1000);
            }
    Scene scene;
    scene.volume = std::make_shared<const Volume>(geometry, std::move(voxels));
    scene.model = Model::maximumIntensity;
    scene.transferFunction = {1, {{0, 0}, {100, 1}}};
    scene.camera = camera;
    scene.film = {300, 300};
    return scene;
}

/// The letter that the bright pixels of `area` look most like, whatever their size; a blank where there are none.
char letterIn(const QImage& area) {
    constexpr int kSide = 24;
    const auto inked = [](const QImage& image) {
        QRect box;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (qGray(image.pixel(x, y)) > 150)
                    box |= QRect(x, y, 1, 1);
        return box.isEmpty() ? QImage()
                             : image.copy(box)
                                   .scaled(kSide, kSide, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
                                   .convertToFormat(QImage::Format_Grayscale8);
    };
    const QImage seen = inked(area);
    char best = ' ';
    double least = 1e9;
    for (const Side& side : kSides) {
        QImage drawn(120, 120, QImage::Format_RGB32);
        drawn.fill(Qt::black);
        QPainter painter(&drawn);
        QFont font;
        font.setPixelSize(80);
        font.setBold(true);
        painter.setFont(font);
        painter.setPen(Qt::white);
        painter.drawText(drawn.rect(), Qt::AlignCenter, QString(QChar(side.letter)));
        painter.end();
        const QImage wanted = inked(drawn);
        double off = 0;
        for (int y = 0; y < kSide && !seen.isNull(); ++y)
            for (int x = 0; x < kSide; ++x)
                off += std::abs(qGray(seen.pixel(x, y)) - qGray(wanted.pixel(x, y)));
        if (!seen.isNull() && off < least)
            std::tie(best, least) = std::pair(side.letter, off);
    }
    return best;
}

/// What stands in the middle of that edge.
char letterAt(const QImage& image, ivec2 edge) {
    const int strip = image.width() / 12, half = image.width() / 2 - strip / 2;
    const QPoint middle(image.width() / 2 + edge.x * half, image.height() / 2 + edge.y * half);
    return letterIn(image.copy(QRect(middle - QPoint(strip / 2, strip / 2), QSize(strip, strip))));
}

/// Towards which edge the bright pixels lie from the middle; (0, 0): no edge.
ivec2 brightSide(const QImage& image) {
    dvec2 sum(0);
    double count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (qGray(image.pixel(x, y)) > 100) {
                sum += dvec2(x - image.width() / 2, y - image.height() / 2);
                ++count;
            }
    const dvec2 middle = sum / std::max(count, 1.0) / double(image.width());
    return {middle.x < -0.05 ? -1 : middle.x > 0.05 ? 1 : 0, middle.y < -0.05 ? -1 : middle.y > 0.05 ? 1 : 0};
}

}  // namespace

class TestAnnotatedFile : public QObject {
    Q_OBJECT

  private slots:
    void theLettersInTheFileAreTheSidesThatAreSeen_data();
    void theLettersInTheFileAreTheSidesThatAreSeen();
    void theNoticeAndTheCubeAreThereAndNobodyIsNamed();
    void whoItIsStandsWhereItIsWanted();
    void radianceCarriesNothing();
    void aTinyImageHasItsLettersAlone();

  private:
    QImage saved(const Scene& scene, const std::optional<ui::Annotations>& annotations,
                 const QString& name = "image.png") const;

    QTemporaryDir folder_;
};

QImage TestAnnotatedFile::saved(const Scene& scene, const std::optional<ui::Annotations>& annotations,
                                const QString& name) const {
    const auto device = makeCpuDevice(1);
    [&] { QVERIFY(device->upload(scene)); }();
    const auto film = *device->film(scene.film, scene.revision, scene.schedule);
    [&] { QVERIFY(BatchRender(*film, {.samples = 1}, {}).run({}, [](const BatchState&) {})); }();
    const std::string cpu = "cpu";
    const QString file = folder_.filePath(name);
    [&] { QVERIFY(writeImage({**film->film(), scene, 1, cpu, {}, {}}, {}, annotations, file)); }();
    return QImage(file);
}

void TestAnnotatedFile::theLettersInTheFileAreTheSidesThatAreSeen_data() {
    QTest::addColumn<int>("type");
    QTest::addColumn<bool>("mirrored");
    for (const bool mirrored : {false, true}) {
        QTest::addRow("perspective%s", mirrored ? ", mirrored" : "") << int(Camera::Type::perspective) << mirrored;
        QTest::addRow("parallel%s", mirrored ? ", mirrored" : "") << int(Camera::Type::orthographic) << mirrored;
    }
}

/// A ball at the side that a letter names is seen towards that letter.
void TestAnnotatedFile::theLettersInTheFileAreTheSidesThatAreSeen() {
    QFETCH(int, type);
    QFETCH(bool, mirrored);
    for (const Camera& camera : axisViews(Camera::Type(type))) {
        const QImage annotated = saved(markedAt(kSides[0], camera, mirrored), ui::Annotations{camera, {}, {}});
        for (const ivec2 edge : kEdges) {
            const char letter = letterAt(annotated, edge);
            const auto side = std::ranges::find(kSides, letter, &Side::letter);
            QVERIFY2(side != kSides.end(), qPrintable(QString("no letter at %1, %2").arg(edge.x).arg(edge.y)));
            Scene marked = markedAt(*side, camera, mirrored);
            marked.film = {60, 60};
            const ivec2 seen = brightSide(saved(marked, {}, "plain.png"));
            QVERIFY2(seen == edge, qPrintable(QString("%1 stands at %2, %3 and is seen at %4, %5")
                                                  .arg(letter)
                                                  .arg(edge.x)
                                                  .arg(edge.y)
                                                  .arg(seen.x)
                                                  .arg(seen.y)));
        }
    }
}

/// Pixels that differ in a part of two images.
static int changed(const QImage& a, const QImage& b, const QRect& part) {
    int count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
        for (int x = part.left(); x <= part.right(); ++x)
            count += a.pixel(x, y) != b.pixel(x, y);
    return count;
}

void TestAnnotatedFile::theNoticeAndTheCubeAreThereAndNobodyIsNamed() {
    const Scene scene = markedAt(kSides[0], axisViews(Camera::Type::perspective)[0], false);
    const QImage plain = saved(scene, {}), annotated = saved(scene, ui::Annotations{scene.camera, {}, {}});
    QVERIFY(changed(plain, annotated, {0, 270, 100, 30}) > 100);   // the notice
    QVERIFY(changed(plain, annotated, {250, 250, 50, 50}) > 500);  // the cube
    QVERIFY(changed(plain, annotated, {200, 200, 100, 45}) > 20);  // the scale bar
    QCOMPARE(changed(plain, annotated, {0, 0, 100, 100}), 0);
    QImage black(300, 300, QImage::Format_RGB32), alone;  // the lowest line is the notice, and no other text
    black.fill(Qt::black);
    alone = black;
    QPainter painter(&alone);
    painter.setFont(QFont());
    ui::paintAnnotations(painter, {scene.camera, {}, {}}, alone.size());
    painter.end();
    QVERIFY(changed(black, alone, {0, 270, 100, 30}) > 100);
}

void TestAnnotatedFile::whoItIsStandsWhereItIsWanted() {
    const Scene scene = markedAt(kSides[0], axisViews(Camera::Type::perspective)[0], false);
    const ui::Annotations sides{scene.camera, {}, {}}, patient{scene.camera, {"Doe, Jane"}, {}};
    const QImage without = saved(scene, sides), with = saved(scene, patient);
    QVERIFY(changed(without, with, {0, 0, 100, 30}) > 100);
    QCOMPARE(changed(without, with, {0, 100, 300, 200}), 0);
}

void TestAnnotatedFile::radianceCarriesNothing() {
    const Scene scene = markedAt(kSides[0], axisViews(Camera::Type::perspective)[0], false);
    saved(scene, {}, "plain.exr");
    saved(scene, ui::Annotations{scene.camera, {"Doe, Jane"}, {"Bone"}}, "annotated.exr");
    const auto plain = readExr(ui::fromQt(folder_.filePath("plain.exr")));
    const auto annotated = readExr(ui::fromQt(folder_.filePath("annotated.exr")));
    QVERIFY(plain && annotated && plain->pixels == annotated->pixels);
}

void TestAnnotatedFile::aTinyImageHasItsLettersAlone() {
    Scene scene = markedAt(kSides[0], axisViews(Camera::Type::perspective)[0], false);
    scene.film = {90, 90};
    const QImage plain = saved(scene, {}), annotated = saved(scene, ui::Annotations{scene.camera, {}, {"Bone"}});
    QVERIFY(changed(plain, annotated, {0, 35, 20, 20}) > 20);
    QCOMPARE(changed(plain, annotated, {0, 60, 30, 30}), 0);
    QCOMPARE(changed(plain, annotated, {60, 60, 30, 30}), 0);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestAnnotatedFile)
#include "annotated_file_test.moc"
