/// The letters at the edges of a view.

#include <QTest>

#include "render/scene/orbit.h"
#include "ui/annotation/orientation_letters.h"

namespace pdr::ui {

static Camera viewFrom(StandardView view) {
    return standardView(view, {12, -40, 300}, 200, 1.3);
}

static QString letters(const EdgeLetters& edges) {
    return QString::fromStdString(edges.left + "|" + edges.right + "|" + edges.top + "|" + edges.bottom);
}

class TestOrientationLetters : public QObject {
    Q_OBJECT

  private slots:
    void axesHaveOneLetter_data();
    void axesHaveOneLetter();
    void obliqueDirectionsNameTheStrongestSideFirst_data();
    void obliqueDirectionsNameTheStrongestSideFirst();
    void fromTheFrontThePatientsRightIsOnTheLeft();
    void everyStandardViewHasItsLetters_data();
    void everyStandardViewHasItsLetters();
    void theLettersStayRightOverAWholeTurn();
    void oppositeEdgesAlwaysHaveOppositeLetters();
};

void TestOrientationLetters::axesHaveOneLetter_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("z");
    QTest::addColumn<QString>("expected");
    QTest::newRow("left") << 1.0 << 0.0 << 0.0 << "L";
    QTest::newRow("right") << -2.0 << 0.0 << 0.0 << "R";
    QTest::newRow("posterior") << 0.0 << 0.1 << 0.0 << "P";
    QTest::newRow("anterior") << 0.0 << -1e6 << 0.0 << "A";
    QTest::newRow("head") << 0.0 << 0.0 << 1.0 << "H";
    QTest::newRow("feet") << 0.0 << 0.0 << -1.0 << "F";
    QTest::newRow("nearly head") << 0.1 << 0.1 << 1.0 << "H";
}

void TestOrientationLetters::axesHaveOneLetter() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, z);
    QFETCH(QString, expected);
    QCOMPARE(QString::fromStdString(orientationLetters({x, y, z})), expected);
}

void TestOrientationLetters::obliqueDirectionsNameTheStrongestSideFirst_data() {
    axesHaveOneLetter_data();
    QTest::newRow("LP") << 1.0 << 0.9 << 0.1 << "LP";
    QTest::newRow("AR") << -0.5 << -0.9 << 0.0 << "AR";
    QTest::newRow("LPH") << 0.8 << 0.6 << 0.4 << "LPH";
    QTest::newRow("FAL") << 0.3 << -0.5 << -0.7 << "FAL";
}

void TestOrientationLetters::obliqueDirectionsNameTheStrongestSideFirst() {
    axesHaveOneLetter();
}

void TestOrientationLetters::fromTheFrontThePatientsRightIsOnTheLeft() {
    QCOMPARE(letters(edgeLetters(viewFrom(StandardView::anterior))), "R|L|H|F");
}

void TestOrientationLetters::everyStandardViewHasItsLetters_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<QString>("towardsViewer");
    QTest::newRow("anterior") << int(StandardView::anterior) << "A";
    QTest::newRow("posterior") << int(StandardView::posterior) << "P";
    QTest::newRow("left") << int(StandardView::left) << "L";
    QTest::newRow("right") << int(StandardView::right) << "R";
    QTest::newRow("superior") << int(StandardView::superior) << "H";
    QTest::newRow("inferior") << int(StandardView::inferior) << "F";
}

void TestOrientationLetters::everyStandardViewHasItsLetters() {
    QFETCH(int, view);
    QFETCH(QString, towardsViewer);
    const Camera camera = viewFrom(StandardView(view));
    QCOMPARE(QString::fromStdString(orientationLetters(-camera.forward())), towardsViewer);
    const EdgeLetters edges = edgeLetters(camera);
    for (const std::string& edge : {edges.left, edges.right, edges.top, edges.bottom})
        QCOMPARE(edge.size(), std::size_t(1));
}

/// Turning the patient to the right shows first his right side, then his back, then his left.
void TestOrientationLetters::theLettersStayRightOverAWholeTurn() {
    Camera camera = viewFrom(StandardView::anterior);
    const auto quarterTurn = [&camera] {
        for (int step = 0; step < 50; ++step)
            camera = orbited(camera, {0.01, 0});
        return letters(edgeLetters(camera));
    };
    QCOMPARE(quarterTurn(), "P|A|H|F");  // the patient's right side is in front: his back on the viewer's left
    QCOMPARE(quarterTurn(), "L|R|H|F");
    QCOMPARE(quarterTurn(), "A|P|H|F");
    QCOMPARE(quarterTurn(), "R|L|H|F");
}

void TestOrientationLetters::oppositeEdgesAlwaysHaveOppositeLetters() {
    const QMap<char, char> opposite{{'L', 'R'}, {'R', 'L'}, {'P', 'A'}, {'A', 'P'}, {'H', 'F'}, {'F', 'H'}};
    Camera camera = viewFrom(StandardView::anterior);
    for (int i = 0; i < 500; ++i) {
        camera = orbited(camera, {0.037, 0.023});
        const EdgeLetters edges = edgeLetters(camera);
        QCOMPARE(edges.left.size(), edges.right.size());
        for (std::size_t k = 0; k < edges.left.size(); ++k)
            QCOMPARE(edges.right[k], opposite[edges.left[k]]);
    }
}

}  // namespace pdr::ui

QTEST_GUILESS_MAIN(pdr::ui::TestOrientationLetters)
#include "orientation_letters_test.moc"
