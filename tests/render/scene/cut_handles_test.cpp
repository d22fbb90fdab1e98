/// Effects of a drag on a cut: faces and planes follow the pointer, from any viewing direction.

#include "render/scene/edit/cut_handles.h"

#include <QTest>

using namespace pdr;

namespace {

const Uncut kBody{{-200, -120, -300}, {180, 140, 100}};
using Kind = CutHandle::Kind;

Camera camera(Camera::Type type, dvec3 eye = {150, -700, 60}) {
    return {.type = type, .eyeMm = eye, .targetMm = {-10, 10, -100}, .fovDegrees = 40, .heightMm = 500};
}

CutGrip grip(const Clip& clip, CutHandle handle, const ViewGeometry& view, dvec3 place) {
    return {clip, kBody, handle, view, *view.at(place)};
}

}  // namespace

class CutHandlesTest : public QObject {
    Q_OBJECT

  private slots:
    /// The pointer moves a face 31 mm further in, in both kinds of view.
    void aFaceFollowsTheHandAlongItsAxis() {
        for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic})
            for (int face = 0; face < 6; ++face) {
                const ViewGeometry view(camera(type, {400, -600, 160}), 1.5);
                const dvec3 middle = faceMiddle(kBody, face);
                dvec3 inwards(0);
                inwards[face / 2] = face % 2 ? -31 : 31;
                const CutGrip held = grip({}, {Kind::face, face}, view, middle);
                const Clip clip = dragged(held, *view.at(middle + inwards));
                for (int other = 0; other < 6; ++other)
                    QVERIFY(std::fabs(cutOffMm(clip, kBody, other) - (other == face ? 31 : 0)) < 1e-9);
                QVERIFY(!dragged(held, held.from).box);
                QVERIFY(!dragged(held, *view.at(middle - inwards)).box);  // it has nothing to add
                QVERIFY(clip.check());
            }
    }

    /// In a view along the axis, up is away.
    void whatComesTowardsTheViewerIsPushedByMovingUp() {
        const ViewGeometry view(camera(Camera::Type::orthographic, {-10, -700, -100}), 1.5);
        const CutGrip held = grip({}, {Kind::face, 2}, view, faceMiddle(kBody, 2));
        QVERIFY(std::fabs(cutOffMm(dragged(held, held.from - dvec2(0, 0.1)), kBody, 2) - 50) < 1e-9);
    }

    void aBoxStaysABox() {
        const ViewGeometry view(camera(Camera::Type::orthographic), 1.5);
        const CutGrip held = grip({}, {Kind::face, 5}, view, faceMiddle(kBody, 5));
        const Clip clip = dragged(held, held.from + dvec2(0, 3));
        QVERIFY(clip.check());
        QVERIFY(clip.box->highMm.z - clip.box->lowMm.z >= 0.999);
        QVERIFY(dragged(grip(clip, {Kind::face, 4}, view, faceMiddle(*clip.box, 4)), dvec2(0, -3)).check());
        QCOMPARE(withCutOff({}, kBody, 3, 1e6).box->highMm.y, kBody.lowMm.y + 1);
        QVERIFY(!withoutCut(clip, kBody, {Kind::face, 5}).box);
    }

    void theWholeBoxFollowsTheHand() {
        const ViewGeometry view(camera(Camera::Type::orthographic, {-10, -700, -100}), 1.5);
        Clip clip = withCutOff(withCutOff({}, kBody, 0, 50), kBody, 1, 60);
        const CutGrip held = grip(clip, {Kind::box, 0}, view, {0, 0, -100});
        clip = dragged(held, *view.at({20, 0, -100}));
        QVERIFY(glm::distance(clip.box->lowMm, dvec3(-130, -120, -300)) < 1e-9);
        QVERIFY(glm::distance(clip.box->highMm, dvec3(140, 140, 100)) < 1e-9);
    }

    void aPlaneFollowsTheHandAlongItsNormal() {
        for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic}) {
            const ViewGeometry view(camera(type), 1.5);
            Clip clip;
            clip.planes = {{{30, 0, 0}, {1, -0.5, 2}}};
            const dvec3 middle = planeMiddle(clip.planes[0], kBody), normal = glm::normalize(dvec3(1, -0.5, 2));
            const double before = planeOffsetMm(clip.planes[0], kBody);
            const CutGrip held = grip(clip, {Kind::offset, 0}, view, middle);
            const ClipPlane plane = dragged(held, *view.at(middle - normal * 17.0)).planes[0];
            QVERIFY(std::fabs(planeOffsetMm(plane, kBody) - before + 17) < 1e-9);
            QCOMPARE(plane.normal, clip.planes[0].normal);
        }
    }

    /// A plane never leaves the body: otherwise it could not be dragged any more.
    void aPlaneStaysInTheBody() {
        const ClipPlane plane = withOffset({{0, 0, 0}, {1, 1, 1}}, kBody, 1e5);
        QVERIFY(planeOutline(plane, kBody).size() >= 3);
    }

    /// A drag by a quarter of the image's height to the right: 45 degrees about the up direction; the middle stays.
    void aRingTurnsThePlaneAsAViewIsTurned() {
        const Camera front = camera(Camera::Type::perspective, {-10, -700, -100});
        const ViewGeometry view(front, 1.5);
        Clip clip;
        clip.planes = {facingPlane(front, kBody)};
        const CutGrip held = grip(clip, {Kind::tilt, 0}, view, {-10, 10, -100});
        const Clip turned = dragged(held, held.from + dvec2(0.25 / 1.5, 0));
        QVERIFY(glm::distance(turned.planes[0].normal, glm::normalize(dvec3(1, -1, 0))) < 1e-9);
        QVERIFY(std::fabs(planeOffsetMm(turned.planes[0], kBody)) < 1e-9);
        const Clip tipped = dragged(held, held.from + dvec2(0, 0.25));
        QVERIFY(glm::distance(tipped.planes[0].normal, glm::normalize(dvec3(0, -1, -1))) < 1e-9);
        QVERIFY(dragged(held, held.from) == clip);
    }

    void planesCutWhatIsNearer() {
        for (const dvec3 eye : {dvec3(500, -600, 300), dvec3(-500, 600, -300)}) {
            const Camera from = camera(Camera::Type::perspective, eye);
            for (int axis = 0; axis < 3; ++axis) {
                const ClipPlane plane = planeAcross(axis, from, kBody);
                QVERIFY(glm::dot(plane.normal, eye - plane.pointMm) > 0);
                QCOMPARE(std::fabs(plane.normal[axis]), 1.0);
            }
            QVERIFY(glm::dot(facingPlane(from, kBody).normal, from.forward()) < -0.999);
        }
    }

    /// A coronal plane's outline is the box' section; an oblique one through the middle is a hexagon.
    void outlinesAreSections() {
        const auto section = planeOutline({{0, 5, 0}, {0, -1, 0}}, kBody);
        QCOMPARE(section.size(), std::size_t(4));
        double around = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            QCOMPARE(section[i].y, 5.0);
            around += glm::distance(section[i], section[(i + 1) % 4]);
        }
        QVERIFY(std::fabs(around - 2 * (380 + 400)) < 1e-9);
        const Uncut cube{dvec3(0), dvec3(1)};
        QCOMPARE(planeOutline({dvec3(0.5), {1, 1, 1}}, cube).size(), std::size_t(6));
        QVERIFY(planeOutline({dvec3(5), {1, 1, 1}}, cube).empty());
    }

    void whatIsGivenUpIsGone() {
        Clip clip = withCutOff({}, kBody, 2, 40);
        clip.planes = {{{0, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}};
        QCOMPARE(withoutCut(clip, kBody, {Kind::tilt, 0}).planes[0].normal, dvec3(0, 1, 0));
        QVERIFY(!withoutCut(clip, kBody, {Kind::box, 0}).box);
        QCOMPARE(withoutCut(clip, kBody, {Kind::box, 0}).planes.size(), std::size_t(2));
    }
};

QTEST_APPLESS_MAIN(CutHandlesTest)
#include "cut_handles_test.moc"
