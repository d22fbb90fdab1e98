/// Every kernel in the program's PTX is known to this room, runs, and gives the bits of the CPU or of the emulated GPU.

#include <QTest>

#include <cxxabi.h>

#include <array>
#include <cstdlib>

#include "render/prepare/needs.h"
#include "tests/ptx/runtime/runtime.h"
#include "tests/ptx/small_scenes.h"
#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/part_scenes.h"

using namespace pdr;
using test::kSamples;
using test::sceneOf;
using test::shot;

namespace {

/// Returns an image of each sample in turn, fetched while the next is taken where the device can.
std::vector<std::uint8_t> images(Device& device, const Scene& scene) {
    std::vector<std::uint8_t> all;
    const auto live = startFilm(device, scene);
    if (!live)
        return all;
    int waiting = 0;
    const auto fetch = [&] {
        if (const auto image = (*live)->readback())
            all.insert(all.end(), image->rgba.begin(), image->rgba.end());
        --waiting;
    };
    for (std::uint32_t n = 0; n < kSamples + 2; ++n) {
        if (!(*live)->accumulate(1, {}) || !(*live)->resolve({}))
            return {};
        if (++waiting == (*live)->maxInFlight())
            fetch();
    }
    while (waiting > 0)
        fetch();
    return all;
}

/// Returns a kernel's name as it is written, cut where a line would end.
std::string written(const std::string& mangled) {
    char* plain = abi::__cxa_demangle(mangled.c_str(), nullptr, nullptr, nullptr);
    const std::string name(plain != nullptr ? plain : mangled.c_str());
    std::free(plain);
    return name.substr(0, 200);
}

}  // namespace

class KernelsTest : public QObject {
    Q_OBJECT

    std::unique_ptr<Device> cpu_ = makeCpuDevice(1), emulated_ = *openDevice("emulated", 1), gpu_;

    bool agree(const Scene& scene, std::uint32_t samples = kSamples) {
        const auto theirs = shot(*cpu_, scene, samples), ours = shot(*gpu_, scene, samples);
        return theirs && ours && sameBits(theirs->content(), ours->content());
    }

  private slots:
    void initTestCase() {
        auto gpu = openDevice("cuda");
        QVERIFY2(gpu, gpu ? "" : gpu.error().text().c_str());
        gpu_ = *std::move(gpu);
    }

    /// A new instruction is met here, whatever runs.
    void everyInstructionIsKnown() {
        ptx::Runtime& runtime = ptx::Runtime::get();
        std::size_t instructions = 0;
        for (auto& [host, kernel] : runtime.kernels.all())
            try {
                instructions += kernel.decoded(runtime.settings).instructions.size();
            } catch (const ptx::NotKnown& error) {
                QFAIL(error.what());
            }
        qInfo("%zu kernels, %zu instructions", runtime.kernels.all().size(), instructions);
        QVERIFY(runtime.kernels.all().size() > 50 && instructions > 100'000);
    }

    void everySetOfEffectsGivesTheCpusBits() {
        for (std::uint32_t features = 0; features < kFeatureMasks; ++features) {
            const Scene scene = sceneOf(features);
            QCOMPARE(neededFeatures(needs(scene)), features);
            QVERIFY2(agree(scene), qPrintable(QString("mask %1").arg(features)));
        }
    }

    void everyOtherModelGivesTheCpusBits() {
        for (const bool masked : {false, true})
            for (const Model model : kModels)
                for (const Estimator estimator : kEstimators) {
                    Scene scene = sceneOf(kSurface | kEnvironment | kEmission);
                    scene.model = model;
                    scene.estimator = estimator;
                    if (masked)
                        scene.mask = test::anyMask(*scene.volume, 1);
                    if (scene.check())
                        QVERIFY2(agree(scene), modelName(model));
                }
    }

    /// In the scenes above, flights look at thin tissue. Where all is dense they are exact.
    void exactFlightsGiveTheCpusBits() {
        for (const bool masked : {false, true}) {
            Scene scene = sceneOf(kSurface);
            scene.transferFunction.extinctionPerMm = 1000;
            if (masked)
                scene.mask = test::anyMask(*scene.volume, 1);
            QVERIFY(agree(scene));
        }
    }

    /// Parts of the patient with curves of their own: thin tissue is looked at, dense tissue is not.
    void partsGiveTheCpusBits() {
        for (const bool dense : {false, true})
            for (const bool masked : {false, true}) {
                Scene scene = sceneOf(kSurface);
                scene.parts.map = test::anyParts(*scene.volume, 3, 1);
                test::giveCurves(scene, 1);
                if (masked)
                    scene.mask = test::anyMask(*scene.volume, 1);
                for (PartCurve& part : scene.parts.curves)
                    part.transferFunction.extinctionPerMm = dense ? 1000 : 0.3f;
                if (dense)
                    scene.transferFunction.extinctionPerMm = 1000;
                QVERIFY2(agree(scene), qPrintable(QString("dense %1, masked %2").arg(dense).arg(masked)));
            }
    }

    void sumsOverPartsGiveTheCpusBits() {
        for (const bool masked : {false, true}) {
            Scene scene = sceneOf(0);
            scene.model = Model::absorption;
            scene.parts.map = test::anyParts(*scene.volume, 3, 1);
            test::giveCurves(scene, 1);
            if (masked)
                scene.mask = test::anyMask(*scene.volume, 1);
            QVERIFY(agree(scene));
        }
    }

    /// Where no light is parallel and no tissue dense, light flies by looks alone.
    void lightByLooksGivesTheCpusBits() {
        for (const bool parted : {false, true})
            for (const bool masked : {false, true}) {
                Scene scene = sceneOf(kSurface);
                scene.lights = {SphereLight{{0, -200, 50}, 20, vec3(30)}};
                scene.transferFunction.extinctionPerMm = 0.3f;
                if (parted) {
                    scene.parts.map = test::anyParts(*scene.volume, 3, 1);
                    test::giveCurves(scene, 1);
                    for (PartCurve& part : scene.parts.curves)
                        part.transferFunction.extinctionPerMm = 0.3f;
                }
                if (masked)
                    scene.mask = test::anyMask(*scene.volume, 1);
                QVERIFY2(agree(scene), qPrintable(QString("parted %1, masked %2").arg(parted).arg(masked)));
            }
    }

    /// The emulated device rounds fractions of textures as this room does.
    void fastFilteringReadsTextures() {
        Scene scene = sceneOf(kSurface);
        scene.filtering = Filtering::fast;
        const auto theirs = shot(*emulated_, scene), ours = shot(*gpu_, scene);
        QVERIFY(theirs && ours && sameBits(theirs->content(), ours->content()));
    }

    void everyScheduleShowsTheSameImages() {
        Scene scene = sceneOf(kSurface | kEnvironment);
        const auto agrees = [&] {
            const std::vector<std::uint8_t> theirs = images(*emulated_, scene);
            return !theirs.empty() && theirs == images(*gpu_, scene);
        };
        QVERIFY(agrees());
        for (const auto& [redundant, filter, runningMean] :
             {std::array{false, false, false}, {true, true, false}, {false, true, true}}) {
            scene.schedule = {Schedule::Kind::kroes, redundant, filter, runningMean};
            QVERIFY(agrees());
        }
    }

    /// Without a filter Exposure Render's schedule has the film's sums, block by block.
    void aBlockOfSamplesIsAddedUp() {
        Scene scene = sceneOf(0);
        scene.film = {4, 4};
        scene.schedule = {Schedule::Kind::kroes, false, false, false};
        QVERIFY(agree(scene, kSamplesPerBlock + 1));
    }

    /// The bounds stay, so nothing but the tables themselves waits between edits of a light.
    void aTableThatIsSentTwiceWaitsForItsLastCopy() {
        Scene scene = sceneOf(kSurface);
        QVERIFY(gpu_->upload(scene));
        for (const float radiance : {1.0f, 3.0f, 0.5f}) {
            scene.lights = {DirectionalLight{{0.4, 1, -0.5}, vec3(radiance)}};
            ++scene.revision;
            QVERIFY(gpu_->upload(scene));
        }
        QVERIFY(agree(scene));
    }

    /// Whatever is added to the device is added above.
    void everyKernelHasRun() {
        std::string missed;
        for (const auto& [host, kernel] : ptx::Runtime::get().kernels.all())
            if (kernel.launches == 0)
                missed += "\n" + written(kernel.name);
        QVERIFY2(missed.empty(), missed.c_str());
    }
};

QTEST_APPLESS_MAIN(KernelsTest)
#include "kernels_test.moc"
