#include <QImage>
#include <QTest>

#include "render/volume/file/label_nrrd.h"
#include "tests/support/scenes/ball_scene.h"

using namespace pdr;
using test::BallScene;
using test::ProgramRun;

/// `pdrender-cli render --part` gives parts of the patient a look of their own, or says why it cannot.
class PartLooksTest : public QObject {
    Q_OBJECT

    BallScene ball_;
    QString labels_;

    ProgramRun render(const QString& image, const QStringList& options) const {
        return BallScene::run(
            QStringList{"render", ball_.scene(), "-o", ball_.at(image), "--samples", "16", "--annotations", "none"} +
            options);
    }

  private slots:
    /// The part "upper" is the half of the ball that is nearer to the head.
    void initTestCase() {
        LabelMap map;
        map.geometry = VolumeGeometry::aligned({32, 32, 32}, dvec3(1), dvec3(0.5));
        map.labels.assign(map.geometry.voxelCount(), 0);
        std::fill(map.labels.begin() + map.labels.size() / 2, map.labels.end(), std::uint8_t(1));
        map.parts = {{"upper", {200, 40, 40}}};
        labels_ = ball_.at("halves.seg.nrrd");
        QVERIFY(bool(writeLabelFile(map, labels_.toStdString())));
    }

    void aPartHasALookOfItsOwn() {
        QCOMPARE(render("none.png", {}).code, 0);
        const ProgramRun made = render("part.png", {"--labels", labels_, "--part", "upper=Muscles"});
        QVERIFY2(made.code == 0, made.err.constData());
        const QImage none(ball_.at("none.png")), part(ball_.at("part.png"));
        const auto apart = [&](int top) {
            int most = 0;
            for (int y = top; y < top + 4; ++y)
                most = std::max(most, std::abs(qBlue(none.pixel(24, y)) - qBlue(part.pixel(24, y))));
            return most;
        };
        QVERIFY2(apart(15) > 20, qPrintable(QString::number(apart(15))));
        QVERIFY2(apart(28) < 8, qPrintable(QString::number(apart(28))));
    }

    void whatCannotBeIsExplained() {
        const ProgramRun unknown = render("a.png", {"--labels", labels_, "--part", "lower=Muscles"});
        QCOMPARE(unknown.code, 1);
        QVERIFY2(unknown.err.contains("no part has the name \"lower\"") && unknown.err.contains("There are: upper."),
                 unknown.err.constData());
        const ProgramRun sums =
            render("a.png", {"--labels", labels_, "--part", "upper=Muscles", "--model", "emissionAbsorption"});
        QCOMPARE(sums.code, 1);
        QVERIFY2(sums.err.contains("knows no materials of parts"), sums.err.constData());
        const ProgramRun sourceless = render("a.png", {"--part", "upper=Muscles"});
        QCOMPARE(sourceless.code, 2);
        QVERIFY2(sourceless.err.contains("--labels or --find says where they come from"), sourceless.err.constData());
        QCOMPARE(render("a.png", {"--labels", labels_, "--part", "upper=Nothing"}).code, 2);
        QVERIFY(!QFile::exists(ball_.at("a.png")));
    }
};

QTEST_GUILESS_MAIN(PartLooksTest)
#include "part_looks_test.moc"
