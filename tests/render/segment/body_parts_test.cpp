/// Parts of a patient that can be shown alone: patients made from formulas, and what a mask shows of them.

#include <QTest>

#include "render/base/errors.h"
#include "render/scene/visible_mask.h"
#include "render/segment/body_parts.h"
#include "render/segment/findings.h"
#include "render/segment/hidden_table.h"
#include "render/volume/coarser.h"
#include "tests/support/dicom/lying_patients.h"

using namespace pdr;
using namespace pdr::test;

namespace {

constexpr dvec3 kSpacingMm{1.5, 1.5, 2.5};
constexpr ivec3 kSize{128, 96, 48};

/// HU of a place [mm] from the middle of the grid.
using Density = std::function<int(dvec3 place)>;

std::shared_ptr<const Volume> patient(const Density& density) {
    const dvec3 middle = dvec3(kSize) * kSpacingMm * 0.5;
    return makeVolume(kSize, kSpacingMm,
                      [&](int i, int j, int k) { return density((dvec3(i, j, k) + 0.5) * kSpacingMm - middle); });
}

bool inBall(dvec3 place, dvec3 centre, double radius) {
    return glm::distance(place, centre) < radius;
}

/// Bone is not even.
int bone(dvec3 place, int hu) {
    return hu +
           (int(std::floor(place.x / 1.5) + std::floor(place.y / 1.5) + std::floor(place.z / 2.5)) & 1 ? 120 : -120);
}

int trunkHu(dvec3 place) {
    return trunk(place) == Matter::body ? kTissueHu : kAirHu;
}

segment::BodyParts partsOf(const std::shared_ptr<const Volume>& volume) {
    return segment::BodyParts(volume);
}

/// The weight at a place [mm] from the middle of the grid.
double at(const Mask& mask, dvec3 place) {
    return mask.at((place / kSpacingMm) + dvec3(kSize) * 0.5 - 0.5);
}

std::string refusal(const segment::PartMask& mask) {
    return !mask && mask.error().kind == ErrorKind::refused ? mask.error().what : Text();
}

}  // namespace

class BodyPartsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Rules that are written in HU would cut other values anywhere.
    void valuesThatAreNoHuHaveNoParts() {
        const auto hu = patient(trunkHu);
        const auto other = std::make_shared<const Volume>(
            hu->geometry(), Voxels(hu->voxels().begin(), hu->voxels().end()), std::vector<bool>(), "no-hu");
        const segment::BodyParts parts(other);
        for (const auto& mask : {parts.peeled(5, other->geometry(), noProgress),
                                 parts.lungs(segment::Use::shown, other->geometry(), noProgress),
                                 parts.bones(segment::Use::hidden, other->geometry(), noProgress)}) {
            QVERIFY(!mask && mask.error().kind == ErrorKind::refused);
            QVERIFY2(mask.error().what.find("no HU") != std::string::npos, mask.error().what.c_str());
        }
        const auto table = segment::hideTable(*other, noProgress);
        QVERIFY(table && !table->body && table->bodyBox.size == kSize);
        QCOMPARE(segment::findingsOn(*other, other->geometry()), segment::Findings());
    }

    /// The middle of the edge lies at the requested depth, within half a cell, and the visible share grows inwards.
    void whatIsPeeledIsAsDeepAsWasAsked() {
        const auto volume = patient(trunkHu);
        for (const double depth : {3.0, 7.0, 20.0, 30.0}) {
            const auto mask = partsOf(volume).peeled(depth, volume->geometry(), noProgress);
            QVERIFY(mask);
            for (const dvec3 way : {dvec3(0, -1, 0), dvec3(0, 1, 0)}) {
                double before = -1;
                for (double below = 0; below < 40; below += 0.25) {
                    const double weight = at(**mask, way * (45 - below));
                    QVERIFY(weight >= before - 1e-9);
                    before = weight;
                    if (below < depth - 2.5)
                        QCOMPARE(weight, 0.0);
                    if (below > depth + 2.5)
                        QCOMPARE(weight, 1.0);
                }
            }
            // Slices at the ends of the scan are no surface.
            QCOMPARE(at(**mask, {0, 0, -59}), 1.0);
        }
    }

    /// A curved surface is peeled evenly: the steps of the cells do not show.
    void peeledSurfacesHaveNoSteps() {
        const auto volume = patient([](dvec3 p) { return inTube(p, {0, 0}, 60) ? kTissueHu : kAirHu; });
        const auto mask = partsOf(volume).peeled(12, volume->geometry(), noProgress);
        QVERIFY(mask);
        double nearest = 1e9, farthest = 0;
        for (int degrees = 0; degrees < 360; ++degrees) {
            const double angle = glm::radians(double(degrees));
            double radius = 60;
            while (at(**mask, {radius * std::cos(angle), radius * std::sin(angle), 3.3}) < 0.5)
                radius -= 0.05;
            nearest = std::min(nearest, radius);
            farthest = std::max(farthest, radius);
        }
        QVERIFY2(std::abs(nearest - 48) < 1.2 && std::abs(farthest - 48) < 1.2,
                 qPrintable(QString("%1 to %2").arg(nearest).arg(farthest)));
        QVERIFY2(farthest - nearest < 1, qPrintable(QString("%1 to %2").arg(nearest).arg(farthest)));
    }

    /// The lungs are shown with the vessels in them, and without what lies near the pleura; bowel gas is no lung.
    void theLungsAreShownWithTheirVessels() {
        const auto lung = [](dvec3 p) { return inTube(p, {-28, 0}, 24) && std::abs(p.z) < 50; };
        const auto gas = [](dvec3 p) { return inTube(p, {28, 0}, 24) && std::abs(p.z) < 50; };
        const auto volume = patient([&](dvec3 p) {
            if (inTube(p, {-28, 0}, 3))
                return kTissueHu;
            return lung(p) ? -850 : gas(p) ? -1000 : trunkHu(p);
        });
        const auto mask = partsOf(volume).lungs(segment::Use::shown, volume->geometry(), noProgress);
        QVERIFY2(mask, mask ? "" : mask.error().text().c_str());
        QCOMPARE(at(**mask, {-28, 0, 0}), 1.0);    // a vessel
        QCOMPARE(at(**mask, {-28, 15, 10}), 1.0);  // beside it
        QCOMPARE(at(**mask, {-28, 22, 10}), 0.0);  // at the pleura
        QCOMPARE(at(**mask, {28, 0, 0}), 0.0);     // gas
        QCOMPARE(at(**mask, {0, 30, 0}), 0.0);     // muscle
        QVERIFY((*mask)->hidden().find("5 mm at the pleura") != std::string::npos);
    }

    /// Marrow and blood have the same HU: what is enclosed by dense bone is bone.
    void marrowIsBoneAndBloodIsNot() {
        const auto volume = patient([](dvec3 p) {
            if (inBall(p, {-25, 0, 0}, 14))
                return bone(p, inBall(p, {-25, 0, 0}, 9) ? 300 : 900);  // marrow in its cortex
            return inTube(p, {25, 0}, 12) ? 420 : trunkHu(p);           // an aorta
        });
        const auto shown = partsOf(volume).bones(segment::Use::shown, volume->geometry(), noProgress);
        const auto hidden = partsOf(volume).bones(segment::Use::hidden, volume->geometry(), noProgress);
        QVERIFY(shown && hidden);
        for (const auto& [place, bone] : {std::pair(dvec3(-25, 0, 0), 1.0), std::pair(dvec3(-25, 0, 12), 1.0),
                                          std::pair(dvec3(25, 0, 0), 0.0), std::pair(dvec3(0, 30, 10), 0.0)}) {
            QCOMPARE(at(**shown, place), bone);
            QCOMPARE(at(**hidden, place), 1 - bone);
        }
        QVERIFY((*shown)->hidden() != (*hidden)->hidden());
    }

    /// Undiluted contrast medium in a vein is as dense as bone, but even.
    void aDenseVeinIsNoBone() {
        const auto volume = patient([](dvec3 p) {
            return inBall(p, {-25, 0, 0}, 14) ? bone(p, 800) : inTube(p, {25, 0}, 9) ? 800 : trunkHu(p);
        });
        const auto hidden = partsOf(volume).bones(segment::Use::hidden, volume->geometry(), noProgress);
        QVERIFY(hidden);
        QCOMPARE(at(**hidden, {25, 0, 0}), 1.0);
        QCOMPARE(at(**hidden, {25, 8, 0}), 1.0);
        QCOMPARE(at(**hidden, {-25, 0, 0}), 0.0);
    }

    /// Chalk in a vessel's wall is dense, but little.
    void chalkIsNoBone() {
        const auto volume = patient([](dvec3 p) {
            if (inBall(p, {25, 12, 0}, 3.5))
                return 1000;
            if (inBall(p, {-25, 0, 0}, 10))
                return bone(p, 1000);
            return inTube(p, {25, 0}, 12) ? 420 : trunkHu(p);
        });
        const auto hidden = partsOf(volume).bones(segment::Use::hidden, volume->geometry(), noProgress);
        QVERIFY(hidden);
        QCOMPARE(at(**hidden, {25, 12, 0}), 1.0);
        QCOMPARE(at(**hidden, {-25, 0, 0}), 0.0);
    }

    void whatIsNotThereIsRefusedWithAReason() {
        const auto volume = patient(trunkHu);
        QVERIFY(refusal(partsOf(volume).lungs(segment::Use::shown, volume->geometry(), noProgress)).find("150 ml") !=
                std::string::npos);
        QVERIFY(refusal(partsOf(volume).bones(segment::Use::shown, volume->geometry(), noProgress)).find("dense") !=
                std::string::npos);
        const auto thin = patient([](dvec3 p) { return std::abs(p.y) < 5 ? kTissueHu : kAirHu; });
        QVERIFY(refusal(partsOf(thin).peeled(5, thin->geometry(), noProgress)).find("20 mm") != std::string::npos);
    }

    void aChoiceMakesTheMaskOfBoth() {
        const auto volume = patient([](dvec3 p) { return inBall(p, {-25, 0, 0}, 30) ? bone(p, 900) : trunkHu(p); });
        QCOMPARE(*visibleMask(partsOf(volume), {}, volume->geometry(), noProgress), nullptr);
        const auto both = visibleMask(partsOf(volume), Visible{{"bones"}, {}, 15}, volume->geometry(), noProgress);
        QVERIFY(both);
        QCOMPARE(at(**both, {-25, 0, 0}), 1.0);
        QCOMPARE(at(**both, {-25, 28, 0}), 0.0);  // bone that is peeled off
        QCOMPARE(at(**both, {20, 0, 0}), 0.0);    // deep, but no bone
        const std::string& text = (*both)->hidden();
        QVERIFY(text.find("Only bones") != std::string::npos && text.find("Peeled 15 mm") != std::string::npos);
    }

    void severalPartsAreShownTogetherOrLeftOut() {
        const auto volume = patient([](dvec3 p) {
            const bool lung = inTube(p, {-28, 0}, 24) && std::abs(p.z) < 50;
            return inBall(p, {20, 0, 0}, 12) ? bone(p, 900) : lung ? -850 : trunkHu(p);
        });
        const segment::BodyParts parts = partsOf(volume);
        const VolumeGeometry& own = volume->geometry();
        const auto bones = parts.bones(segment::Use::shown, own, noProgress),
                   lungs = parts.lungs(segment::Use::shown, own, noProgress),
                   noBones = parts.bones(segment::Use::hidden, own, noProgress),
                   noLungs = parts.lungs(segment::Use::hidden, own, noProgress);
        const auto both = visibleMask(parts, {{"bones", "lungs"}}, own, noProgress),
                   neither = visibleMask(parts, {{}, {"bones", "lungs"}}, own, noProgress),
                   onlyBones = visibleMask(parts, {{"bones"}, {"lungs"}}, own, noProgress),
                   onlyLungs = visibleMask(parts, {{"bones", "lungs"}, {"bones"}}, own, noProgress);
        QVERIFY(both && neither && onlyBones && onlyLungs);
        const auto near = [](double a, double b) { return std::abs(a - b) <= 2.0 / kSeen; };
        const ivec3 size = (*both)->grid().size();
        for (int i = 0; i < size.x * size.y * size.z; i += 7) {
            const dvec3 node = (*both)->grid().place({i % size.x, i / size.x % size.y, i / (size.x * size.y)});
            QVERIFY(near((*lungs)->at(node) + (*noLungs)->at(node), 1));
            QVERIFY(near((*both)->at(node), std::max((*bones)->at(node), (*lungs)->at(node))));
            QVERIFY(near((*neither)->at(node), (*noBones)->at(node) * (*noLungs)->at(node)));
            QVERIFY(near((*onlyBones)->at(node), (*bones)->at(node) * (*noLungs)->at(node)));
            QVERIFY(near((*onlyLungs)->at(node), (*both)->at(node) * (*noBones)->at(node)));
        }
        QCOMPARE((*both)->hidden(), Text("Only bones and the lungs are shown."));
    }

    void aLabelThatNothingHasIsRefused() {
        const auto volume = patient(trunkHu);
        const std::string why = refusal(visibleMask(partsOf(volume), {{"liver"}}, volume->geometry(), noProgress));
        QVERIFY(why.find("liver") != std::string::npos);
    }

    /// The voxels of small images are coarser and lie elsewhere.
    void aMaskForOtherVoxelsShowsTheSamePlaces() {
        const auto volume = patient(trunkHu);
        const VolumeGeometry own = volume->geometry();
        const VolumeGeometry coarse = coarser(*volume, 3).geometry();
        QVERIFY(coarse.size != own.size);
        const segment::BodyParts parts = partsOf(volume);
        const auto fine = parts.peeled(7, own, noProgress), other = parts.peeled(7, coarse, noProgress);
        QVERIFY(fine && other);
        QCOMPARE((*other)->grid(), MaskGrid::over(coarse));
        QCOMPARE((*other)->hidden(), (*fine)->hidden());
        double worst = 0;
        for (int i = 0; i < 500; ++i) {
            const ivec3 node = ivec3(i, 3 * i, 7 * i) % (*other)->grid().size();
            const dvec3 place = (*other)->grid().place(node);
            const dvec4 inPatient = coarse.patientFromIndex * dvec4(place, 1.0);
            const dvec3 inOwn = dvec3(glm::inverse(own.patientFromIndex) * inPatient);
            worst = std::max(worst, std::abs((*other)->at(place) - (*fine)->at(inOwn)));
        }
        QVERIFY2(worst < 0.2, qPrintable(QString::number(worst)));  // what the fine one's nodes bend
    }

    /// The masks do not depend on the order of requests, nor on a search that was cancelled before.
    void whatIsKnownChangesNothing() {
        const auto volume = patient([](dvec3 p) { return inBall(p, {-25, 0, 0}, 20) ? bone(p, 900) : trunkHu(p); });
        const VolumeGeometry& own = volume->geometry();
        const segment::BodyParts parts = partsOf(volume);
        QVERIFY(!parts.peeled(3, own, [](double fraction, std::string_view) { return fraction < 0.2; }));
        QVERIFY(!refusal(parts.lungs(segment::Use::shown, own, noProgress)).empty());
        for (const double depth : {3.0, 30.0, 12.0, 3.0}) {
            const auto again = parts.peeled(depth, own, noProgress);
            const auto fresh = partsOf(volume).peeled(depth, own, noProgress);
            QVERIFY(again && fresh && (*again)->weights() == (*fresh)->weights());
        }
        QVERIFY(parts.bones(segment::Use::shown, own, noProgress));
        const auto again = parts.bones(segment::Use::hidden, own, noProgress);
        const auto fresh = partsOf(volume).bones(segment::Use::hidden, own, noProgress);
        QVERIFY(again && fresh && (*again)->weights() == (*fresh)->weights());
    }

    void allCanBeCancelled() {
        const auto volume = patient([](dvec3 p) { return inBall(p, {0, 0, 0}, 20) ? bone(p, 900) : trunkHu(p); });
        for (const Visible& visible :
             {Visible{{"lungs"}}, Visible{{"bones"}}, Visible{{}, {}, 5}, Visible{{}, {"bones"}, 5},
              Visible{{"bones", "lungs"}}, Visible{{"bones"}, {"lungs"}, 5}}) {
            int calls = 0;
            double last = 0;
            const auto all =
                visibleMask(partsOf(volume), visible, volume->geometry(), [&](double fraction, std::string_view) {
                    ++calls;
                    const bool grows = fraction >= last && fraction <= 1;
                    last = fraction;
                    return grows;
                });
            QVERIFY(all || all.error().kind == ErrorKind::refused);
            QVERIFY(calls >= 20);
            for (int until = 0; until < calls; until += until < 10 ? 1 : calls / 10) {
                int left = until;
                bool stopped = false;  // how often the calling thread asks hangs on what the others take
                const auto mask =
                    visibleMask(partsOf(volume), visible, volume->geometry(), [&](double, std::string_view) {
                        stopped = stopped || left-- <= 0;
                        return !stopped;
                    });
                QVERIFY(stopped || until > 0);
                QCOMPARE(!mask && mask.error().kind == ErrorKind::cancelled, stopped);
            }
        }
    }
};

QTEST_GUILESS_MAIN(BodyPartsTest)
#include "body_parts_test.moc"
