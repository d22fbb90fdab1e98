#include <QTest>

#include <random>

#include "render/device/emulated/emulated_gpu.h"
#include "render/film/display/tone_map.h"
#include "render/kernel/pixel.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/scenes/tissue_scene.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

Scene someScene() {
    Scene scene = test::tissueScene();
    scene.film = {70, 45};  // its right and lower cells are cut
    scene.revision = 3;
    return scene;
}

Tile wholeOf(const Scene& scene) {
    return wholeImage(scene.film);
}

/// Returns the sums of a tile as another machine computes them: the block's samples up to `end`.
TileResult resultOf(const Scene& scene, const Tile& tile, std::uint64_t end) {
    const std::uint64_t block = (end - 1) / kSamplesPerBlock * kSamplesPerBlock;
    TileResult result{scene.revision, tile, {block, std::uint32_t(end - block)}, {}, {}};
    result.sums.resize(std::size_t(tile.width) * std::size_t(tile.height));
    CpuTracer().trace(Flattener().prepare(scene)->flat, tile, result.samples, {result.sums.data(), tile.width});
    return result;
}

/// Returns the moments of a tile as another machine computes them: all blocks up to `end`.
TileResult blocksOf(const Scene& scene, const Tile& tile, std::uint64_t end) {
    const auto flat = Flattener().prepare(scene);
    Film film(tile, scene.revision);
    for (SampleRange block{0, kSamplesPerBlock}; block.first < end; block.first += kSamplesPerBlock) {
        CpuTracer().trace(flat->flat, tile, block, film.sums(tile));
        film.commit(block);
    }
    FilmContent content = film.content();
    return {scene.revision, tile, {0, std::uint32_t(end)}, content.block, content.health, content.moments};
}

std::uint64_t pixelsIn(const std::vector<EvenTile>& tiles) {
    std::uint64_t pixels = 0;
    for (const EvenTile& even : tiles)
        pixels += std::uint64_t(even.tile.width) * std::uint64_t(even.tile.height);
    return pixels;
}

/// A tile and the end of its samples.
struct MovingTile {
    Tile tile;
    std::uint64_t end = 0;
};

/// Returns the image divided between cells: into rows, and each row into columns of its own.
std::vector<MovingTile> randomTiles(ivec2 film, std::mt19937& random) {
    const auto part = [&](int left) { return std::min(left, kFilmCell * int(1 + random() % 3)); };
    std::vector<MovingTile> tiles;
    for (int y = 0, height = 0; y < film.y; y += height) {
        height = part(film.y - y);
        for (int x = 0, width = 0; x < film.x; x += width) {
            width = part(film.x - x);
            tiles.push_back({{x, y, width, height}});
        }
    }
    return tiles;
}

}  // namespace

/// Tests films whose parts have different numbers of samples or are computed elsewhere: the result is the same to the
/// bit.
class FilmOfRegionsTest : public QObject {
    Q_OBJECT

  private slots:
    void progressIsKeptByCells() {
        const Tile area{100, 200, 70, 45};
        TileProgress progress(area, 128);
        QVERIFY((progress.evenTiles(area) == std::vector{EvenTile{area, 128}}));
        QVERIFY((progress.counts() == SampleCounts{0, 0, 0}));
        const Tile region{120, 210, 10, 10};
        const Tile cells = progress.cellsAround(region);
        QVERIFY((cells == Tile{116, 200, 16, 32}));
        QVERIFY(progress.isWholeCells(cells) && !progress.isWholeCells(region));
        QVERIFY((progress.cellsAround({165, 240, 5, 5}) == Tile{164, 232, 6, 13}));  // cut by the edges
        progress.advance(cells, 138);
        const std::vector<EvenTile> even = progress.evenTiles(area);
        QVERIFY(even.size() <= 5);
        QCOMPARE(pixelsIn(even), std::uint64_t(70 * 45));
        QCOMPARE(progress.counts().least, std::uint64_t(0));
        QCOMPARE(progress.counts().most, std::uint64_t(10));
        QCOMPARE(progress.counts().mean, 10.0 * 16 * 32 / (70 * 45));
        progress.advance({164, 232, 6, 13}, 148);
        QCOMPARE(progress.counts().mean, (10.0 * 16 * 32 + 20.0 * 6 * 13) / (70 * 45));
        QVERIFY(progress.evenTiles({100, 200, 0, 0}).empty());
    }

    /// Tiles of equal progress cover their region once, whatever came before.
    void evenTilesCoverTheirRegionOnce() {
        std::mt19937 random(4);
        const Tile area{0, 0, 150, 90};
        TileProgress progress(area);
        for (int step = 0; step < 200; ++step) {
            const int x = int(random() % 150), y = int(random() % 90);
            const Tile cells = progress.cellsAround(
                {x, y, 1 + int(random() % unsigned(150 - x)), 1 + int(random() % unsigned(90 - y))});
            std::vector<int> covered(150 * 90);
            for (const EvenTile& even : progress.evenTiles(cells)) {
                QVERIFY(isInside(even.tile, cells) && progress.isWholeCells(even.tile));
                QCOMPARE(progress.evenTiles(even.tile).size(), std::size_t(1));
                for (int py = even.tile.y; py < even.tile.y + even.tile.height; ++py)
                    for (int px = even.tile.x; px < even.tile.x + even.tile.width; ++px)
                        ++covered[std::size_t(py * 150 + px)];
                progress.advance(even.tile, even.next + random() % 3);
            }
            QCOMPARE(std::count(covered.begin(), covered.end(), 1), std::ptrdiff_t(cells.width) * cells.height);
            QCOMPARE(std::count(covered.begin(), covered.end(), 0),
                     std::ptrdiff_t(150 * 90) - std::ptrdiff_t(cells.width) * cells.height);
        }
    }

    /// A region may run ahead across blocks; when the rest has caught up the film is that of all pixels at once.
    void regionsThatRunAheadChangeNoBit() {
        const Scene scene = someScene();
        for (const bool gpu : {false, true}) {
            const auto device = gpu ? makeEmulatedGpu() : makeCpuDevice();
            QVERIFY(device->upload(scene));
            const auto film = *device->film(scene.film, scene.revision, {});
            const Tile region{20, 10, 30, 20}, cells{16, 0, 48, 32};
            QVERIFY(film->accumulate(region, 100, {}));
            QVERIFY(film->accumulate(7, {}));
            const auto ahead = *film->film();
            QCOMPARE(ahead->samples().least, std::uint64_t(7));
            QCOMPARE(ahead->samples().most, std::uint64_t(107));
            QCOMPARE(ahead->pixel(20, 10).count, std::uint64_t(107));
            QCOMPARE(ahead->pixel(69, 44).count, std::uint64_t(7));
            QVERIFY(film->resolve({}));
            const Result<Image> image = film->readback();
            QVERIFY(image);
            QCOMPARE(image->status.samplesPerPixel, std::uint64_t(7));
            QCOMPARE(image->status.mostSamplesPerPixel, std::uint64_t(107));
            QCOMPARE(image->status.meanSamplesPerPixel, ahead->samples().mean);
            QVERIFY(std::isinf(image->status.displayError));  // of all pixels, and some have seven samples
            for (const EvenTile& even : ahead->progress().evenTiles(wholeOf(scene)))
                if (!isInside(even.tile, cells))
                    QVERIFY(film->accumulate(even.tile, 100, {}));
            QVERIFY(sameBits((*film->film())->content(), test::render(scene, 107).content()));
        }
    }

    /// The halves are the means of even and odd samples, and both together the mean of all.
    void halvesAreThoseOfEvenAndOddSamples() {
        const auto value = [](std::uint64_t sample) { return float(1 + (sample * 2654435761u) % 1000) / 256; };
        for (const std::uint64_t samples : {1ull, 2ull, 5ull, 64ull, 65ull, 1000ull}) {
            Film film(Tile{0, 0, 1, 1}, 1);
            dvec3 sums[2]{dvec3(0), dvec3(0)};
            std::uint64_t counts[2]{};
            while (film.samplesPerPixel() < samples) {
                const SampleRange range = film.nextSamples(std::uint32_t(samples - film.samplesPerPixel()));
                for (std::uint64_t sample = range.first; sample < range.end(); ++sample) {
                    addSample(*film.sums(film.area()).pixels, vec3(value(sample)), sample);
                    sums[sample % 2] += dvec3(value(sample));
                    ++counts[sample % 2];
                }
                film.commit(range);
            }
            const PixelEstimate pixel = film.pixel(0, 0);
            const double even = sums[0].x / double(counts[0]);
            const double odd = counts[1] > 0 ? sums[1].x / double(counts[1]) : pixel.mean.x;
            QVERIFY(std::fabs(pixel.halves.even.x - even) < 1e-6 * even);
            QVERIFY(std::fabs(pixel.halves.odd.x - odd) < 1e-6 * odd);
            const double both = (pixel.halves.even.x * double(counts[0]) + pixel.halves.odd.x * double(counts[1]));
            QVERIFY(std::fabs(both / double(samples) - pixel.mean.x) < 1e-12);
        }
    }

    /// Half the difference of the halves is a draw of the mean's error: images of other seeds differ as much. Standard
    /// errors, which take the samples for independent, are far larger.
    void theHalvesTellTheNoise() {
        Scene scene = someScene();
        std::vector<Film> films;
        for (scene.seed = 1; scene.seed <= 8; ++scene.seed)
            films.push_back(test::render(scene, 256));
        double draws = 0, errors = 0, truth = 0;
        for (int y = 0; y < scene.film.y; ++y)
            for (int x = 0; x < scene.film.x; ++x) {
                test::Sample means;
                for (const Film& film : films) {
                    const PixelEstimate pixel = film.pixel(x, y);
                    means.add(pixel.mean.x);
                    draws += pixel.errorDraw.x * pixel.errorDraw.x;
                    errors += pixel.standardError.x * pixel.standardError.x;
                }
                truth += double(films.size() * films.size()) * means.standardError() * means.standardError();
            }
        QVERIFY2(std::fabs(draws / truth - 1) < 0.15, qPrintable(QString::number(draws / truth)));
        QVERIFY2(errors > 2 * truth, qPrintable(QString::number(errors / truth)));
    }

    /// Tiles that were computed elsewhere, in any order of tiles, block by block and with a part of a block before,
    /// make the film of one device.
    void mergedTilesAreOneDevicesFilm() {
        const Scene scene = someScene();
        std::vector<Tile> tiles{{0, 0, 32, 32}, {32, 0, 38, 16}, {32, 16, 38, 16}, {0, 32, 70, 13}};
        std::mt19937 random(5);
        Film film(wholeOf(scene), scene.revision);
        for (const std::uint64_t end : {3ull, 50ull, 64ull, 70ull, 128ull, 131ull}) {
            std::ranges::shuffle(tiles, random);
            for (const Tile& tile : tiles) {
                const Result<void> merged = film.merge(resultOf(scene, tile, end));
                QVERIFY2(merged, merged ? "" : merged.error().text().c_str());
            }
        }
        QVERIFY(sameBits(film.content(), test::render(scene, 131).content()));
    }

    /// The result does not depend on how the image is cut into tiles and the samples of each into pieces, nor on their
    /// order.
    void anyOrderAndAnySplitIsTheSameFilm() {
        const Scene scene = someScene();
        const std::uint64_t samples = 150;
        const FilmContent whole = test::render(scene, samples).content();
        for (std::uint32_t seed = 1; seed <= 2; ++seed) {
            std::mt19937 random(seed);
            std::vector<MovingTile> tiles = randomTiles(scene.film, random);
            Film film(wholeOf(scene), scene.revision);
            while (!tiles.empty()) {
                MovingTile& next = tiles[random() % tiles.size()];
                next.end = std::min(
                    {samples, (next.end / kSamplesPerBlock + 1) * kSamplesPerBlock, next.end + 1 + random() % 40});
                QVERIFY(film.merge(resultOf(scene, next.tile, next.end)));
                if (next.end == samples) {
                    next = tiles.back();
                    tiles.pop_back();
                }
            }
            QVERIFY(sameBits(film.content(), whole));
        }
    }

    void whatDoesNotFitIsRefusedAndChangesNothing() {
        const Scene scene = someScene();
        const Tile tile{16, 16, 16, 16};
        Film film(wholeOf(scene), scene.revision);
        const TileResult good = resultOf(scene, tile, 10);
        const auto refusal = [&](TileResult result) {
            const FilmContent before = film.content();
            const Result<void> merged = film.merge(result);
            if (!sameBits(before, film.content()))
                return std::string("the film changed");
            return std::string(merged ? Text() : merged.error().what);
        };
        const auto changed = [&](auto&& change) {
            TileResult result = good;
            change(result);
            return refusal(result);
        };
        QVERIFY(changed([](TileResult& r) { r.revision = 2; }).ends_with("another scene"));
        QVERIFY(changed([](TileResult& r) { r.tile.x = 17; }).ends_with("no such tile is asked for"));
        QVERIFY(changed([](TileResult& r) { r.tile = {64, 32, 16, 16}; }).ends_with("no such tile is asked for"));
        QVERIFY(changed([](TileResult& r) { r.tile = {-16, 0, 16, 16}; }).ends_with("no such tile is asked for"));
        QVERIFY(changed([](TileResult& r) { r.tile.width = -16; }).ends_with("no such tile is asked for"));
        QVERIFY(changed([](TileResult& r) { r.sums.pop_back(); }).ends_with("no such tile is asked for"));
        QVERIFY(changed([](TileResult& r) { r.samples.first = 64; }).ends_with("not the next ones"));
        QVERIFY(changed([](TileResult& r) { r.samples = {0, 65}; }).ends_with("not the next ones"));
        QVERIFY(changed([](TileResult& r) { r.samples = {1, 9}; }).ends_with("not the next ones"));
        QVERIFY(changed([](TileResult& r) { r.samples.count = 0; }).ends_with("there already"));
        QVERIFY(changed([](TileResult& r) { r.sums[7].count = 11; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.sums[7].sum.y = NAN; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.sums[7].sum.y = -1; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.sums[7].sumOfSquares.z = INFINITY; }).ends_with("its sums are none"));
        QVERIFY(film.merge(good));
        QVERIFY(refusal(good).ends_with("there already"));
        QVERIFY(refusal(resultOf(scene, tile, 5)).ends_with("there already"));
        const TileResult beside = resultOf(scene, {0, 16, 32, 16}, 10);  // half of it is new
        QVERIFY(refusal(beside).ends_with("not the next ones"));
    }

    void blocksThatAreMergedTogetherAreThoseOfOneDevice() {
        const Scene scene = someScene();
        const Tile tile{16, 16, 32, 16};
        const FilmContent truth = test::render(scene, 192).content();
        Film film(wholeOf(scene), scene.revision);
        QVERIFY(film.merge(resultOf(scene, tile, 10)));  // which the blocks replace
        QVERIFY(film.merge(blocksOf(scene, tile, 128)));
        const FilmContent between = film.content();
        for (int y = tile.y; y < tile.y + tile.height; ++y)
            for (int x = tile.x; x < tile.x + tile.width; ++x)
                QVERIFY(between.block[std::size_t(y) * std::size_t(scene.film.x) + std::size_t(x)].sum == dvec3(0));
        QCOMPARE(film.fullBlocks(tile).size(), std::size_t(32 * 16));
        QVERIFY(film.fullBlocks({0, 0, 16, 16}).empty());
        QVERIFY(film.merge(resultOf(scene, tile, 192)));
        const FilmContent content = film.content();
        for (int y = tile.y; y < tile.y + tile.height; ++y) {
            const std::size_t row = std::size_t(y) * std::size_t(scene.film.x) + std::size_t(tile.x);
            const auto ofTile = [&](const auto& pixels) { return std::span(pixels).subspan(row, 32); };
            QVERIFY(sameBits(ofTile(content.moments), ofTile(truth.moments)));
            QVERIFY(sameBits(ofTile(content.block), ofTile(truth.block)));
        }
    }

    void blocksThatDoNotFitAreRefused() {
        const Scene scene = someScene();
        const TileResult good = blocksOf(scene, {16, 16, 16, 16}, 128);
        Film film(wholeOf(scene), scene.revision);
        const auto changed = [&](auto&& change) {
            TileResult result = good;
            change(result);
            const Result<void> merged = film.merge(result);
            return std::string(merged ? Text() : merged.error().what);
        };
        QVERIFY(changed([](TileResult& r) { r.moments.clear(); }).ends_with("not the next ones"));
        QVERIFY(changed([](TileResult& r) { r.samples.count = 130; }).ends_with("not the next ones"));
        QVERIFY(changed([](TileResult& r) { r.samples.first = 64; }).ends_with("not the next ones"));
        QVERIFY(changed([](TileResult& r) { r.moments.pop_back(); }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.sums[7].count = 1; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.moments[7].count = 129; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.moments[7].evenCount = 129; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.moments[7].mean.x = NAN; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.moments[7].m2.y = -1; }).ends_with("its sums are none"));
        QVERIFY(changed([](TileResult& r) { r.moments[7].evenMean.z = INFINITY; }).ends_with("its sums are none"));
        QVERIFY(film.merge(good));
        QVERIFY(changed([](TileResult&) {}).ends_with("there already"));
    }

    void aFilmThatIsRestartedIsAFreshOne() {
        Scene scene = someScene();
        for (const bool gpu : {false, true}) {
            const auto device = gpu ? makeEmulatedGpu() : makeCpuDevice();
            QVERIFY(device->upload(scene));
            const auto film = *device->film(scene.film, scene.revision, {});
            QVERIFY(film->accumulate(70, {}) && film->resolve({}));
            Scene next = scene;
            next.camera.eyeMm.x += 20;
            next.film = {64, 50};
            next.revision = 8;
            QVERIFY(device->upload(next) && film->restart(wholeOf(next), next.revision));
            QVERIFY(film->accumulate(66, {}));
            QCOMPARE((*film->film())->revision(), std::uint64_t(8));
            QVERIFY(sameBits((*film->film())->content(), test::render(next, 66).content()));
            QVERIFY(film->resolve({}));
            const Result<Image> image = film->readback();  // not the one that was ordered before
            QVERIFY(image && image->rgba == toneMap(**film->film(), {}));
        }
    }

    void exposureRendersScheduleTakesWholeImagesOnly() {
        const Scene scene = someScene();
        const auto device = makeCpuDevice();
        QVERIFY(device->upload(scene));
        const auto film = *device->film(scene.film, scene.revision, {.kind = Schedule::Kind::kroes});
        QVERIFY(!film->accumulate({0, 0, 16, 16}, 1, {}));
        QVERIFY(film->accumulate(1, {}));
    }
};

QTEST_GUILESS_MAIN(FilmOfRegionsTest)
#include "film_of_regions_test.moc"
