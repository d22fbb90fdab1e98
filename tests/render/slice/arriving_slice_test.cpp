/// Slices of a volume that is still being read: what has arrived is what it stays, and nothing else is shown.

#include <QTest>

#include <algorithm>
#include <cmath>
#include <thread>

#include "render/slice/arriving_slice.h"
#include "render/slice/slice_stack.h"
#include "tests/support/scenes/made_volume.h"

using namespace pdr;

namespace {

void arrive(ArrivingVolume& arriving, const Volume& volume, int k) {
    const std::size_t count = std::size_t(volume.size().x) * std::size_t(volume.size().y);
    std::ranges::copy(volume.voxels().subspan(std::size_t(k) * count, count), arriving.slice(k).begin());
    arriving.arrive(k);
}

/// A plane along no axis of the volume.
SlicePlane obliquePlane(const Volume& volume) {
    const dvec3 right = glm::normalize(dvec3(1, 0.3, 0.2));
    const dvec3 down = glm::normalize(glm::cross(dvec3(0.1, 0.2, 1), right));
    return SlicePlane::around(volume.geometry().centreMm(), right, down, 0.5, {90, 80});
}

std::vector<SlicePlane> planesThrough(const Volume& volume) {
    std::vector<SlicePlane> planes{obliquePlane(volume)};
    for (const AnatomicalPlane plane : kAnatomicalPlanes) {
        const SliceStack stack(volume.geometry(), plane);
        for (int i = 0; i < stack.count(); ++i)
            planes.push_back(stack.slice(i));
        planes.push_back(stack.at(stack.positionMm(volume.geometry().centreMm()) + 0.3));
    }
    return planes;
}

bool same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

}  // namespace

class ArrivingSliceTest : public QObject {
    Q_OBJECT

  private slots:
    void completeVolumeLooksAsItStays_data() { volumes(); }
    void completeVolumeLooksAsItStays() {
        const Volume volume = chosen();
        ArrivingVolume arriving(volume.geometry());
        for (int k = 0; k < volume.size().z; ++k)
            arrive(arriving, volume, volume.size().z - 1 - k);
        for (const SlicePlane& plane : planesThrough(volume)) {
            const auto arrived = reslice(arriving, plane), stays = reslice(volume, plane);
            QVERIFY(arrived && std::ranges::equal(arrived->hu, stays->hu, same));
        }
    }

    void slicesThatAreNotThereAreNoAir_data() { volumes(); }
    /// The voxels that have not arrived hold something here, which must not be read.
    void slicesThatAreNotThereAreNoAir() {
        const Volume volume = chosen();
        const std::vector<int> there{3, 4, 5, 9, 16};
        ArrivingVolume arriving(volume.geometry());
        for (int k = 0; k < volume.size().z; ++k)
            std::ranges::fill(arriving.slice(k), std::int16_t(12345));
        for (const int k : there)
            arrive(arriving, volume, k);
        const dmat4 indexFromPatient = glm::inverse(volume.geometry().patientFromIndex);
        int shown = 0, hatched = 0, wrong = 0;
        for (const SlicePlane& plane : planesThrough(volume)) {
            const auto arrived = reslice(arriving, plane), stays = reslice(volume, plane);
            QVERIFY(arrived && arrived->hu.size() == stays->hu.size());
            for (int y = 0; y < plane.size.y; ++y)
                for (int x = 0; x < plane.size.x; ++x) {
                    const float hu = arrived->at({x, y}), final = stays->at({x, y});
                    const double z = (indexFromPatient * dvec4(plane.mmAt({x, y}), 1)).z;
                    const double nearest = std::clamp(std::floor(z + 0.5), 0.0, double(volume.size().z - 1));
                    const bool isOnEdge = std::abs(z - std::floor(z) - 0.5) < 1e-3;  // where a bit decides
                    if (isOnEdge || std::isnan(final) || std::isnan(hu))
                        continue;
                    const bool isThere = std::ranges::find(there, int(nearest)) != there.end();
                    const bool areNeighboursThere = (z >= 3 && z <= 5) || std::abs(z - nearest) < 1e-9;
                    if (!isThere)
                        wrong += hu != kNotArrived;
                    else if (areNeighboursThere)
                        wrong += std::abs(hu - final) > 0.01f;
                    else
                        wrong += hu < -1000 || hu > 3000;
                    ++(isThere ? shown : hatched);
                }
        }
        QCOMPARE(wrong, 0);
        QVERIFY(shown > 1000 && hatched > 1000);
    }

    void outsideOfTheScanNothingIsAwaited() {
        const Volume volume = test::madeVolume();
        const ArrivingVolume arriving(volume.geometry());
        const auto nothing = reslice(arriving, obliquePlane(volume)), stays = reslice(volume, obliquePlane(volume));
        int differing = 0;
        for (std::size_t i = 0; i < nothing->hu.size(); ++i)
            differing += std::isnan(nothing->hu[i]) != std::isnan(stays->hu[i]);
        QVERIFY(differing <= 4);  // on the very edge a bit decides
        QVERIFY(std::ranges::count(nothing->hu, kNotArrived) > 500);
    }

    /// From then on its voxels change: the table is hidden in the same memory.
    void takenVoxelsAreNotLookedAt() {
        const Volume volume = test::madeVolume();
        ArrivingVolume arriving(volume.geometry());
        for (int k = 0; k < volume.size().z; ++k)
            arrive(arriving, volume, k);
        const std::int16_t* before = arriving.slice(0).data();
        const Voxels voxels = arriving.take();
        QCOMPARE(voxels.data(), before);  // not copied
        QVERIFY(std::ranges::equal(voxels, volume.voxels()));
        QVERIFY(!reslice(arriving, obliquePlane(volume)));
        QVERIFY(arriving.take().empty());
    }

    /// Under ThreadSanitizer this shows that a slice is complete before it is seen, and nobody looks once it is taken.
    void slicesMayBeLookedAtAtAnyMoment() {
        const Volume volume = test::madeVolume();
        const SlicePlane plane = obliquePlane(volume);
        for (int round = 0; round < 20; ++round) {
            ArrivingVolume arriving(volume.geometry());
            std::atomic<int> wrong = 0;
            const auto look = [&] {
                while (const auto image = reslice(arriving, plane))
                    wrong += std::ranges::any_of(
                        image->hu, [](float hu) { return !(std::isnan(hu) || hu == kNotArrived || hu <= 3000); });
            };
            std::jthread one(look), other(look);
            std::vector<std::jthread> readers;
            for (int reader = 0; reader < 2; ++reader)
                readers.emplace_back([&, reader] {
                    for (int k = reader; k < volume.size().z; k += 2)
                        arrive(arriving, volume, k);
                });
            readers.clear();
            Voxels voxels = arriving.take();
            std::ranges::fill(voxels, std::int16_t(9999));
            one.join();
            other.join();
            QCOMPARE(wrong, 0);
        }
    }

  private:
    static void volumes() {
        QTest::addColumn<bool>("sheared");
        QTest::newRow("turned") << false;
        QTest::newRow("of a tilted gantry") << true;
    }
    static Volume chosen() {
        QFETCH(bool, sheared);
        return sheared ? test::shearedVolume() : test::madeVolume();
    }
};

QTEST_APPLESS_MAIN(ArrivingSliceTest)
#include "arriving_slice_test.moc"
