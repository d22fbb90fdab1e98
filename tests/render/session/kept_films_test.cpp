/// A kept film is found for its own scene alone, whatever field another scene differs in, and films stay within their
/// memory.

#include <QTest>
#include <functional>

#include "render/session/kept_films.h"
#include "tests/support/devices/fake_clock.h"
#include "tests/support/scenes/changed_field.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

std::shared_ptr<const Mask> someMask(const Volume& volume) {
    const MaskGrid grid = MaskGrid::over(volume.geometry());
    return maskOf(grid, {}, [](dvec3) { return std::int16_t(1); });
}

/// A scene in which no list and no optional value is empty.
Scene fullScene() {
    Scene scene = test::plainScene(test::bumpyVolume({8, 8, 8}, dvec3(1), 3), 1);
    scene.mask = someMask(*scene.volume);
    scene.parts = {std::make_shared<const LabelMap>(), {PartCurve{1, scene.transferFunction}}};
    scene.lights.push_back(RectangleLight{});
    scene.lights.push_back(SphereLight{});
    scene.environment.nadir = vec3(0.5f);
    scene.environment.image = std::make_shared<const EnvironmentImage>();
    scene.background = vec3(0.25f);
    scene.clip.box = ClipBox{dvec3(0), dvec3(8)};
    scene.clip.planes = {ClipPlane{}};
    scene.clip.freehand = {FreehandCut{scene.camera, {{0, 0}, {0, 1}, {1, 0}}, false}};
    return scene;
}

KeptScene kept(const Scene& scene, bool texturesFilter = false) {
    return {scene, texturesFilter};
}

std::shared_ptr<const KeptFilm> filmOf(const Scene& scene, ivec2 size, std::uint64_t samples = 1) {
    FilmContent content = Film(size, scene.revision).content();
    content.progress.advance(wholeImage(size), samples);
    return std::make_shared<const KeptFilm>(
        KeptFilm{kept(scene),
                 {std::make_shared<const Film>(scene.revision, std::move(content)), {}},
                 nullptr,
                 QualityTracker({})});
}

/// The first `count` views of one volume.
std::vector<Scene> views(int count) {
    std::vector<Scene> scenes(std::size_t(count), fullScene());
    for (int i = 0; i < count; ++i) {
        scenes[std::size_t(i)] = scenes[0];
        scenes[std::size_t(i)].camera.eyeMm.x += i;
    }
    return scenes;
}

constexpr ivec2 kSize{10, 10};
constexpr std::size_t kBytes = 100 * (sizeof(Moments) + sizeof(PixelSums));  // of a film of that size

}  // namespace

class KeptFilmsTest : public QObject {
    Q_OBJECT

  private slots:
    /// The names are all members of a Scene: one that is new does not compile until it has been added to this test.
    void noMemberOfASceneIsLeftOut() {
        const auto& [volume, mask, transferFunction, parts, model, estimator, schedule, filtering, window,
                     toleranceLevels, phaseG, gradientFactor, rayOrigin, unshadowed, lights, environment, background,
                     camera, clip, visible, ctDenoised, maskAwaited, film, maxBounces, seed, revision, lookName] =
            fullScene();
        QVERIFY(volume && mask && parts.map && !unshadowed);
    }

    /// Every field that scene files hold, by its smallest change.
    void everyDescribedFieldCounts() {
        const Scene scene = fullScene();
        std::size_t fields = 0;
        for (;; ++fields) {
            Scene other = scene;
            test::ChangedField change(fields);
            describe(change, other);
            if (change.name().empty())
                break;
            const bool counts = !change.name().starts_with("visible.") && change.name() != "ctDenoised";
            QVERIFY2((kept(scene) == kept(other)) != counts, change.name().c_str());
        }
        QVERIFY(fields > 80);
    }

    void everyFieldOfALightCounts() {
        for (std::size_t light = 0; light < 3; ++light)
            for (std::size_t field = 0;; ++field) {
                Scene scene = fullScene();
                test::ChangedField change(field);
                std::visit([&](auto& one) { describe(change, one); }, scene.lights[light]);
                if (change.name().empty())
                    break;
                QVERIFY2(kept(scene) != kept(fullScene()), change.name().c_str());
            }
    }

    void everyOtherMemberCounts_data() {
        QTest::addColumn<std::function<void(Scene&)>>("change");
        QTest::addColumn<bool>("counts");
        const auto row = [](const char* name, std::function<void(Scene&)> change, bool counts = true) {
            QTest::newRow(name) << std::move(change) << counts;
        };
        row("volume", [](Scene& s) { s.volume = test::bumpyVolume({8, 8, 8}, dvec3(1), 3); });
        row("mask", [](Scene& s) { s.mask = someMask(*s.volume); });
        row("no mask", [](Scene& s) { s.mask = nullptr; });
        row("unshadowed", [](Scene& s) { s.unshadowed = true; });
        row("no light", [](Scene& s) { s.lights.pop_back(); });
        row("lights' order", [](Scene& s) { std::swap(s.lights[0], s.lights[1]); });
        row("environment", [](Scene& s) { s.environment.radiance.y = 0.1f; });
        row("environment's visibility", [](Scene& s) { s.environment.visible = false; });
        row("nadir", [](Scene& s) { s.environment.nadir->z = 0.1f; });
        row("no nadir", [](Scene& s) { s.environment.nadir.reset(); });
        row("environment's image", [](Scene& s) { s.environment.image = std::make_shared<const EnvironmentImage>(); });
        row("environment's rotation", [](Scene& s) { s.environment.rotationDegrees = 1; });
        row(
            "revision", [](Scene& s) { ++s.revision; }, false);
        row(
            "name of the look", [](Scene& s) { s.lookName = "x"; }, false);
        row(
            "mask awaited", [](Scene& s) { s.maskAwaited = true; }, false);
    }
    void everyOtherMemberCounts() {
        QFETCH(const std::function<void(Scene&)>, change);
        QFETCH(const bool, counts);
        const Scene scene = fullScene();
        Scene other = scene;
        change(other);
        QCOMPARE(kept(scene) != kept(other), counts);
    }

    void samplesOfTextureUnitsAreOthers() {
        const Scene scene = fullScene();
        QVERIFY(kept(scene, true) == kept(scene, true));
        QVERIFY(kept(scene, true) != kept(scene, false));
    }

    /// An address alone may be that of another volume by now.
    void aReleasedVolumeNeverComesBack() {
        KeptFilms films;
        Scene scene = fullScene();
        films.keep(filmOf(scene, kSize));
        const std::weak_ptr<const Volume> volume = scene.volume;
        const KeptScene before = kept(scene);
        scene = {};
        QVERIFY(volume.expired());
        QVERIFY(before.isGone());
        QVERIFY(!films.find(kept(fullScene())));
        const Scene next = fullScene();
        films.keep(filmOf(next, kSize));
        QCOMPARE(films.bytes(), kBytes);
    }

    void theFilmUsedLongestAgoGoesFirst() {
        const std::vector<Scene> scenes = views(4);
        KeptFilms films(3 * kBytes + kBytes / 2);
        for (int i = 0; i < 3; ++i)
            films.keep(filmOf(scenes[std::size_t(i)], kSize));
        QVERIFY(films.find(kept(scenes[0])));
        films.keep(filmOf(scenes[3], kSize));
        QVERIFY(!films.find(kept(scenes[1])));
        for (const int i : {0, 2, 3})
            QVERIFY(films.find(kept(scenes[std::size_t(i)])));
    }

    void filmsStayWithinTheirMemory() {
        const std::vector<Scene> scenes = views(9);
        KeptFilms films(3 * kBytes);
        for (const Scene& scene : scenes) {
            films.keep(filmOf(scene, kSize));
            QVERIFY(films.bytes() <= 3 * kBytes);
        }
        QCOMPARE(films.bytes(), 3 * kBytes);
        films.limit(kBytes);
        QCOMPARE(films.bytes(), kBytes);
        films.keep(filmOf(scenes[0], {20, 20}));  // more than all
        QCOMPARE(films.bytes(), std::size_t(0));
    }

    void theLongerOfTwoFilmsOfASceneStays() {
        const Scene scene = fullScene();
        KeptFilms films;
        films.keep(filmOf(scene, kSize, 5));
        films.keep(filmOf(scene, kSize, 3));
        QCOMPARE(films.find(kept(scene))->film.film->samplesPerPixel(), std::uint64_t(5));
        films.keep(filmOf(scene, kSize, 7));
        QCOMPARE(films.find(kept(scene))->film.film->samplesPerPixel(), std::uint64_t(7));
        QCOMPARE(films.bytes(), kBytes);
    }

    void theImageAndTheJudgementCount() {
        auto frame = std::make_shared<Frame>();
        frame->rgba.resize(400);
        frame->errorMap = std::make_shared<const LevelErrorMap>(LevelErrorMap{kSize, std::vector<std::uint8_t>(100)});
        const std::shared_ptr<const KeptFilm> bare = filmOf(fullScene(), kSize);
        const KeptFilm shown{bare->scene, bare->film, frame, bare->quality};
        QCOMPARE(shown.bytes(), kBytes + 500);
    }

    /// What a film keeps for the next edit counts as its memory.
    void theFirstSamplesTakeMemoryToo() {
        KeptFilm film = *filmOf(fullScene(), kSize);
        film.edits.first.keep(*film.film.film);
        QCOMPARE(film.bytes(), kBytes + 100 * 2 * 3 * sizeof(float));
        film.edits.image = keptImage(noisyFilm(*film.film.film), {denoise::coloursOf(kSize), denoise::coloursOf(kSize)},
                                     1, film.edits.first);
        QCOMPARE(film.bytes(), kBytes + 100 * 5 * 3 * sizeof(float));
        film.edits.first.keepUnshadowed(denoise::guideOf(kSize, 2));
        QCOMPARE(film.bytes(), kBytes + 100 * 6 * 3 * sizeof(float));
    }
};

QTEST_APPLESS_MAIN(KeptFilmsTest)
#include "kept_films_test.moc"
