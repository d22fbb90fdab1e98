#include <QtTest>

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <cmath>

#include "app/bench/filtering/price.h"
#include "render/kernel/pixel.h"
#include "tests/support/patience.h"
#include "tests/support/places.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;
using namespace pdr::bench;

namespace {

/// A film of `size` whose pixels all have that mean.
Film evenFilm(ivec2 size, double radiance) {
    PixelSums sums{};
    for (std::uint64_t i = 0; i < 64; ++i)
        addSample(sums, vec3(float(radiance)), i);
    FilmContent content = Film(size, 1).content();
    content.progress.advance(content.progress.area(), 64);
    content.moments.assign(content.moments.size(), merged(Moments{}, sums));
    return Film(1, content);
}

}  // namespace

class BenchFilteringTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    struct Ran {
        int code;
        QString out, err;
    };
    Ran run(const QStringList& words) {
        QProcess process;
        process.start(PDR_BINARY_DIR "/bin/pdrender-bench", QStringList{"filtering"} + words);
        if (!process.waitForFinished(test::kPatience))
            return {-1, "", "it did not end"};
        return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
    }
    QString sceneFile(const QByteArray& model, std::int16_t lowest) {
        QFile voxels(folder_.filePath("volume.raw"));
        const auto volume = test::bumpyVolume({20, 20, 20}, dvec3(1), 1);
        Voxels hu(volume->voxels().begin(), volume->voxels().end());
        hu[0] = lowest;
        (void)voxels.open(QIODevice::WriteOnly);
        voxels.write(reinterpret_cast<const char*>(hu.data()), qint64(2 * hu.size()));
        QFile scene(folder_.filePath("scene.json"));
        (void)scene.open(QIODevice::WriteOnly);
        scene.write(R"({ "format": "pdrender-scene", "version": 1,
            "volume": { "raw": "volume.raw", "size": [20, 20, 20], "spacingMm": [1, 1, 1] },
            "transferFunction": { "extinctionPerMm": 1, "nodes": [
                { "hu": 0, "opacity": 0 }, { "hu": 800, "opacity": 1, "albedo": 0.9 } ] },
            "model": ")" +
                    model + R"(",
            "lights": [ { "type": "directional", "direction": [1, 2, -1.5], "irradiance": 3 } ],
            "camera": { "eyeMm": [10, -40, 10], "targetMm": [10, 10, 10], "up": [0, 0, 1] },
            "film": { "width": 40, "height": 40 } })");
        return scene.fileName();
    }

  private slots:
    void levelsAreThoseOfTheDisplay() {
        const Film exact = evenFilm({4, 3}, 0.5), fast = evenFilm({4, 3}, 0.51);
        const LevelPrice none = levelPrice(exact, exact), price = levelPrice(exact, fast);
        QCOMPARE(none.pixels, std::size_t(0));
        QCOMPARE(none.mean, 0.0);
        QCOMPARE(price.pixels, std::size_t(12));
        const auto level = [](double radiance) {  // sRGB of 1 - exp(-L)
            return 255 * (1.055 * std::pow(1 - std::exp(-radiance), 1 / 2.4) - 0.055);
        };
        const double difference = level(double(0.51f)) - level(0.5);
        QVERIFY(difference > 1);
        for (const double value : {price.mean, price.largest, price.shift})
            QVERIFY(std::fabs(value - difference) < 1e-6);
        QCOMPARE(price.offByOne, 1.0);
    }

    void huDifferencesAreOrderedAndPossible() {
        const auto prepared = test::prepared(test::plainScene(test::bumpyVolume({30, 30, 30}, dvec3(1), 2), 1));
        const HuPrice price = huPrice(prepared->flat.volume, 100'000, 1);
        QVERIFY(0 < price.rms && price.rms < price.almostAll && price.almostAll < price.largest);
        QVERIFY(price.largest <= price.possible);
        QCOMPARE(huPrice(prepared->flat.volume, 100'000, 1).largest, price.largest);
    }

    void priceIsToldInWordsAndAsJson() {
        const QStringList words{
            sceneFile("singleScattering", 0), "--samples", "8", "--points", "10000", "--rounds", "1"};
        const Ran text = run(words), json = run(words + QStringList{"--json"});
        QVERIFY2(text.code == 0 && json.code == 0, qPrintable(text.err + json.err));
        QVERIFY(text.out.contains("can only be measured on a GPU"));
        const QJsonObject all = QJsonDocument::fromJson(json.out.toUtf8()).object();
        const QJsonObject hu = all["hu"].toObject(), levels = all["levels"].toObject(), time = all["time"].toObject();
        QCOMPARE(all["onGpu"].toBool(true), false);
        QCOMPARE(hu["places"].toInt(), 10000);
        QVERIFY(hu["rms"].toDouble() > 0 && hu["largest"].toDouble() <= hu["possible"].toDouble());
        QVERIFY(levels["pixels"].toInt() > 500);
        QVERIFY(levels["mean"].toDouble() > 0 && levels["mean"].toDouble() < levels["standardError"].toDouble());
        QVERIFY(time["exactSeconds"].toDouble() > 0 && time["fastOverExact"].toDouble() > 0);
    }

    void whatHasNoChoiceIsRefused() {
        const Ran projection = run({sceneFile("emission", 0)});
        QCOMPARE(projection.code, 1);
        QVERIFY(projection.err.contains("always filtered exactly"));
        const Ran padded = run({sceneFile("singleScattering", -32768)});
        QCOMPARE(padded.code, 1);
        QVERIFY(padded.err.contains("-32768") && padded.err.contains("clampHu"));
        QCOMPARE(run({sceneFile("singleScattering", 0), "--samples", "none"}).code, 2);
        QCOMPARE(run({sceneFile("singleScattering", 0), "--device", "toaster"}).code, 1);
    }
};

QTEST_GUILESS_MAIN(BenchFilteringTest)
#include "bench_filtering_test.moc"
