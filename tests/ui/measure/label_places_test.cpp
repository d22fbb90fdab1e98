/// Labels beside their places: none covers another, and each is near its own.

#include <QTest>
#include <random>

#include "ui/measure/label_places.h"

namespace pdr::ui {
namespace {

const QRectF kView(0, 0, 600, 400);
constexpr QSizeF kSize(70, 14);

/// Returns how far a rectangle lies from a point [px].
double distance(const QRectF& label, QPointF at) {
    const double x = std::max({label.left() - at.x(), 0.0, at.x() - label.right()}),
                 y = std::max({label.top() - at.y(), 0.0, at.y() - label.bottom()});
    return std::hypot(x, y);
}

}  // namespace

class LabelPlacesTest : public QObject {
    Q_OBJECT

  private slots:
    void aLabelAloneStandsToTheUpperRight() {
        const auto labels = labelPlaces({{{300, 200}, kSize}}, kView);
        QCOMPARE(labels.size(), std::size_t(1));
        QCOMPARE(labels[0].size(), kSize);
        QVERIFY(labels[0].left() > 300 && labels[0].bottom() < 200 && distance(labels[0], {300, 200}) < 12);
    }

    void labelsOfNearPlacesDoNotCoverOneAnother() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> offset(-12, 12);
        for (int trial = 0; trial < 100; ++trial) {
            std::vector<LabelWish> wishes;
            for (int i = 0; i < 8; ++i)
                wishes.push_back({QPointF(300 + offset(random), 200 + offset(random)), kSize});
            const auto labels = labelPlaces(wishes, kView);
            for (std::size_t i = 0; i < labels.size(); ++i) {
                QVERIFY(kView.contains(labels[i]) && distance(labels[i], wishes[i].at) < 140);
                for (std::size_t j = 0; j < labels.size(); ++j) {
                    QVERIFY(i == j || !labels[i].intersects(labels[j]));
                    QVERIFY(!labels[i].contains(wishes[j].at));
                }
            }
        }
    }

    void labelsStayInTheView() {
        for (const QPointF corner : {QPointF(1, 1), QPointF(599, 1), QPointF(1, 399), QPointF(599, 399)})
            QVERIFY(kView.contains(labelPlaces({{corner, kSize}}, kView)[0]));
    }

    /// Where there is no room at all, labels are shown all the same.
    void noLabelIsLost() {
        const std::vector<LabelWish> wishes(300, {{300, 200}, kSize});
        QCOMPARE(labelPlaces(wishes, kView).size(), wishes.size());
    }
};

}  // namespace pdr::ui

QTEST_GUILESS_MAIN(pdr::ui::LabelPlacesTest)
#include "label_places_test.moc"
