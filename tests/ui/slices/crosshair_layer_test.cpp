/// The crosshair in the image: it is painted where its place is seen, whatever the view.

#include <QImage>
#include <QPainter>
#include <QTest>

#include "render/scene/edit/view_geometry.h"
#include "render/scene/orbit.h"
#include "ui/slices/crosshair_layer.h"

namespace pdr::ui {
namespace {

/// Returns the middle of the box around all pixels that `layer` paints over a black image of the view.
std::optional<QPointF> middleOfPainting(const CrosshairLayer& layer, const Camera& camera) {
    QImage image(400, 300, QImage::Format_RGB32);
    image.fill(Qt::black);
    QPainter painter(&image);
    layer.paint(painter, {image.size(), QRectF(0, 0, 400, 300), camera});
    painter.end();
    QRect box;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (image.pixel(x, y) != qRgb(0, 0, 0))
                box |= QRect(x, y, 1, 1);
    if (box.isEmpty())
        return std::nullopt;
    return QRectF(box).center();
}

}  // namespace

class CrosshairLayerTest : public QObject {
    Q_OBJECT

  private slots:
    void itLiesWhereThePlaceIsSeen_data() {
        QTest::addColumn<int>("view");
        QTest::addColumn<bool>("parallel");
        for (int view = 0; view < 6; ++view)
            for (const bool parallel : {false, true})
                QTest::addRow("view %d, %s", view, parallel ? "parallel" : "perspective") << view << parallel;
    }
    void itLiesWhereThePlaceIsSeen() {
        QFETCH(int, view);
        QFETCH(bool, parallel);
        Camera camera = standardView(StandardView(view), {5, 10, -20}, 150, 4.0 / 3);
        if (parallel)
            camera.type = Camera::Type::orthographic;
        CrosshairLayer layer;
        for (const dvec3 place : {dvec3(5, 10, -20), dvec3(-20, 30, 0), dvec3(30, -15, -45)}) {
            layer.setPlace(place);
            const auto at = ViewGeometry(camera, 4.0 / 3).at(place);
            const auto middle = middleOfPainting(layer, camera);
            QVERIFY(at && middle);
            const double off = std::hypot(middle->x() - 400 * at->x, middle->y() - 300 * at->y);
            QVERIFY2(off < 2, qPrintable(QString::number(off)));  // arms towards the viewer look a little longer
        }
    }

    void itIsSeenWhetherThePlaceIsHidden() {
        const Camera camera = standardView(StandardView::anterior, {0, 0, 0}, 150, 4.0 / 3);
        CrosshairLayer layer;
        layer.setPlace(dvec3(0));
        const auto painted = [&](InFront inFront) {
            layer.setInFront(inFront, {});
            QImage image(400, 300, QImage::Format_RGB32);
            image.fill(Qt::black);
            QPainter painter(&image);
            layer.paint(painter, {image.size(), QRectF(0, 0, 400, 300), camera});
            return image;
        };
        QVERIFY(painted(InFront::little) != painted(InFront::tissue));
        QVERIFY(painted(InFront::little) != painted(InFront::cut));
        QCOMPARE(painted(InFront::little), painted(InFront::little));
    }

    /// What was said of one place is not said of the next.
    void anotherPlaceIsNotKnownYet() {
        CrosshairLayer layer;
        layer.setPlace(dvec3(0));
        layer.setInFront(InFront::tissue, "behind 3 mm of tissue");
        layer.setPlace(dvec3(1));
        QVERIFY(layer.inFront() == InFront::unknown);
        layer.setPlace(std::nullopt);
        QVERIFY(!middleOfPainting(layer, standardView(StandardView::anterior, {0, 0, 0}, 150, 4.0 / 3)));
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::CrosshairLayerTest)
#include "crosshair_layer_test.moc"
