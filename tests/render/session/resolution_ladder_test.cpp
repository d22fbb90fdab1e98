/// First images come in time on any device, and the steps from there to the full film are cheap.

#include <QTest>
#include <cmath>

#include "render/session/resolution_ladder.h"

using namespace pdr;

namespace {

constexpr ivec2 kFilm{1600, 1000};

ResolutionLadder measured(double samplesPerSecond, double beginning = 0) {
    ResolutionLadder ladder;
    ladder.addBeginning(beginning);
    ladder.addFrame(samplesPerSecond, 1);
    return ladder;
}

double samplesOf(int divider) {
    const ivec2 size = dividedFilm(kFilm, divider);
    return double(size.x) * size.y * ResolutionLadder::kSamples;
}

}  // namespace

class ResolutionLadderTest : public QObject {
    Q_OBJECT

  private slots:
    void aFirstImageComesInTimeAndNoCoarserThanThat() {
        for (const double speed : {1e6, 3e6, 1e7, 5e7, 1e9})
            for (const double beginning : {0.0, 0.01, 0.02}) {
                const ResolutionLadder ladder = measured(speed, beginning);
                const int divider = ladder.first(kFilm);
                QVERIFY(divider >= 1 && divider <= ResolutionLadder::kCoarsest);
                const auto seconds = [&](int at) { return beginning + samplesOf(at) / speed; };
                // Films have whole pixels, and the last of them may be cut off.
                if (divider < ResolutionLadder::kCoarsest)
                    QVERIFY(seconds(divider) <= 1.1 * ResolutionLadder::kFrameSeconds);
                if (divider > 1)
                    QVERIFY(seconds(divider - 1) > ResolutionLadder::kFrameSeconds);
            }
    }

    /// The display takes as long as the samples.
    void whatADisplayCostsIsLeftForIt() {
        const ResolutionLadder quick = measured(4e6);
        ResolutionLadder ladder = quick;
        ladder.addDisplay(1e6, 1);
        const ivec2 size = dividedFilm(kFilm, ladder.first(kFilm));
        const double pixels = double(size.x) * size.y, samples = samplesOf(ladder.first(kFilm)) / ladder.speed();
        QVERIFY(ladder.first(kFilm) > quick.first(kFilm));
        QVERIFY(samples + pixels * 1e-6 <= 1.1 * ResolutionLadder::kFrameSeconds);
        QVERIFY(std::abs(ladder.secondsForSamples(pixels) - (ResolutionLadder::kFrameSeconds - pixels * 1e-6)) < 1e-9);
    }

    /// Who drags sees the next image soon; who has made one edit looks at the first.
    void anEditAloneHasAFinerImageThanADrag() {
        for (const double speed : {1e5, 1e6, 4e6})
            for (const double beginning : {0.0, 0.01}) {
                ResolutionLadder ladder = measured(speed, beginning);
                ladder.addCoarseEditDisplay(0.01);
                QVERIFY(ladder.forEdit(kFilm, false) < ladder.forEdit(kFilm, true) ||
                        ladder.forEdit(kFilm, false) == ResolutionLadder::kCoarsest);
                const double alone = ladder.secondsForEdit(false) + beginning + 0.01;
                QVERIFY(std::abs(alone - ResolutionLadder::kRestingEditSeconds) < 1e-9);
                QVERIFY(samplesOf(ladder.forEdit(kFilm, false)) / speed <= 1.1 * ladder.secondsForEdit(false) ||
                        ladder.forEdit(kFilm, false) == ResolutionLadder::kCoarsest);
            }
    }

    /// A turn of the view takes longer to begin than an edit in it.
    void whatAViewTakesToBeginIsNoEdits() {
        const ResolutionLadder turned = measured(4e6, 0.05);
        QVERIFY(turned.forEdit(kFilm, false) < measured(1e6, 0.05).forEdit(kFilm, false));
        ResolutionLadder edited = turned;
        edited.addEditBeginning(0.01);
        QVERIFY(edited.forEdit(kFilm, false) < turned.forEdit(kFilm, false));
        QCOMPARE(edited.secondsForSamples(1), turned.secondsForSamples(1));
        for (int i = 0; i < 9; ++i)
            edited.addBeginning(0.2);
        QVERIFY(std::abs(edited.secondsForEdit(false) - turned.secondsForEdit(false) - 0.015) < 1e-9);
    }

    /// Full films have no guide and leave no time for one.
    void whatAGuideCostsIsLeftForIt() {
        ResolutionLadder ladder = measured(4e6);
        ladder.addDisplay(1e9, 1);
        ladder.addGuidedDisplay(1e6, 2);
        const ivec2 size = dividedFilm(kFilm, ladder.first(kFilm));
        const double pixels = double(size.x) * size.y, samples = samplesOf(ladder.first(kFilm)) / ladder.speed();
        QVERIFY(samples + pixels * 2e-6 <= 1.1 * ResolutionLadder::kFrameSeconds);
        QVERIFY(std::abs(ladder.secondsForSamples(pixels) - (ResolutionLadder::kFrameSeconds - pixels * 2e-6)) < 1e-9);
        QCOMPARE(ladder.first({100, 100}), 1);
    }

    void aGuideIsNoFinerThanTheFullFilm() {
        for (int divider = 1; divider <= ResolutionLadder::kCoarsest; ++divider) {
            QVERIFY(ResolutionLadder::finer(divider) <= divider);
            QVERIFY(ResolutionLadder::finer(divider) <= ResolutionLadder::finer(divider + 1));
        }
        QCOMPARE(ResolutionLadder::finer(ResolutionLadder::kCoarsest), ResolutionLadder::kGuide);
    }

    /// Otherwise the full film would have fewer pixels than the image before it.
    void noImageIsLargerThanTheFullFilm() {
        for (int size = 100; size < 1100; ++size)
            for (int divider = ResolutionLadder::kCoarsest; divider > 1; divider = ResolutionLadder::next(divider))
                QVERIFY(ResolutionLadder::finer(divider) * dividedFilm(ivec2(size), divider).x <= size);
    }

    void aSlowDeviceStillShowsSomething() {
        QCOMPARE(measured(1).first(kFilm), ResolutionLadder::kCoarsest);
        QVERIFY(measured(1e6, 10).first(kFilm) <= ResolutionLadder::kCoarsest);
        QVERIFY(measured(1e6, 10).secondsForSamples(1) > 0);
        QVERIFY(dividedFilm({3, 1}, 16) == ivec2(1, 1));
    }

    void oneSlowFrameChangesNothing() {
        ResolutionLadder ladder = measured(1e7);
        for (int i = 0; i < 4; ++i)
            ladder.addFrame(1e7, 1);
        const int usual = ladder.first(kFilm);
        ladder.addFrame(1e7, 50);
        ladder.addFrame(1e7, 0);  // the clock stood still
        QCOMPARE(ladder.first(kFilm), usual);
        for (int i = 0; i < 3; ++i)
            ladder.addFrame(1e7, 9);
        QVERIFY(ladder.first(kFilm) > usual);
    }

    /// The full image is not put off for coarse ones that take as long, unless it takes very long itself.
    void fullImagesOnFeaturesFollowTheCoarsestAtOnce() {
        constexpr ivec2 kView{447, 655}, kHuge{4000, 3000};
        const ResolutionLadder ladder = measured(1e6);
        QCOMPARE(ladder.nextOnFeatures(24, kView), 12);
        QCOMPARE(ladder.nextOnFeatures(12, kView), 6);
        for (const int divider : {11, 7, 6, 5, 3, 2, 1})
            QCOMPARE(ladder.nextOnFeatures(divider, kView), 1);
        for (int divider = ResolutionLadder::kCoarsest; divider > 0; --divider)
            QCOMPARE(ladder.nextOnFeatures(divider, kHuge), ResolutionLadder::next(divider));
    }

    void theStepsEndAtTheFilmAndCostAThirdOfIt() {
        for (int first = 1; first <= ResolutionLadder::kCoarsest; ++first) {
            double cost = 0;
            int divider = first;
            for (; divider > 1; divider = ResolutionLadder::next(divider))
                cost += samplesOf(divider) / samplesOf(1);
            QCOMPARE(divider, 1);
            QVERIFY(cost < 0.35);
        }
    }
};

QTEST_GUILESS_MAIN(ResolutionLadderTest)
#include "resolution_ladder_test.moc"
