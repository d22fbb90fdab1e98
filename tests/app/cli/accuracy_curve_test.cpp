/// What is read off measured curves of accuracy against time.

#include "tests/support/scenes/tissue_scene.h"  // before Qt, whose word "emit" TBB uses

#include <sys/stat.h>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

#include "app/cli/accuracy/accuracy_page.h"
#include "app/cli/accuracy/measure_accuracy.h"

using namespace pdr;
using namespace pdr::app;

namespace {

/// levels = high seconds^-slope, at least `floor`, at 1, 2, 4, ... 64 samples of 0.1 s.
AccuracyCurve curveOf(double high, double slope, double floor = 0) {
    AccuracyCurve curve{"a way", floor > 0 ? "a bias" : "", {}};
    for (std::uint64_t samples = 1; samples <= 64; samples *= 2) {
        const double seconds = 0.1 * double(samples);
        curve.steps.push_back({samples, seconds, {0.1, std::max(floor, high * std::pow(seconds, -slope))}});
    }
    return curve;
}

bool near(std::optional<double> is, double expected) {
    return is && std::fabs(*is / expected - 1) < 1e-9;
}

}  // namespace

class AccuracyCurveTest : public QObject {
    Q_OBJECT

  private slots:
    void betweenStepsTheTimeFollowsThePowerLaw() {
        const AccuracyCurve curve = curveOf(20, 0.5);
        QVERIFY(near(secondsToReach(20, curve), 1));
        QVERIFY(near(secondsToReach(10, curve), 4));
        QVERIFY(near(secondsToReach(20 / std::sqrt(3.3), curve), 3.3));
        QVERIFY(near(secondsToReach(200, curve), 0.1));  // the first step has it
        QVERIFY(!secondsToReach(7, curve));
        QVERIFY(!secondsToReach(1, {}));
    }
    /// What is better by luck for a moment is not reached.
    void onlyWhatLastsIsReached() {
        AccuracyCurve curve = curveOf(20, 0.5);
        curve.steps[1].error.levels = 1;
        QVERIFY(near(secondsToReach(10, curve), 4));
    }
    void blurIsTheBetterImageUntilItsBiasShows() {
        const AccuracyCurve unbiased = curveOf(20, 0.5), blurred = curveOf(10, 0.5, 12);
        const auto until = betterUntil(blurred, unbiased);
        QVERIFY(until && std::fabs(*until / (100.0 / 36) - 1) < 0.05);  // 20 / sqrt(t) = 12
        QVERIFY(std::isinf(*betterUntil(curveOf(10, 0.5, 1), unbiased)));
        QVERIFY(!betterUntil(curveOf(30, 0.5, 12), unbiased));
        QVERIFY(!betterUntil({}, unbiased));
    }
    void theLadderNamesWhatWasReached() {
        QCOMPARE(QString::fromStdString(ladderText(curveOf(16, 0.5))), QString("±32 in 0.25 s, ±16 in 1 s, ±8 in 4 s"));
        QCOMPARE(QString::fromStdString(ladderText(curveOf(1000, 0.1))), QString("not yet within ±32"));
    }
    void aSceneIsAlsoMadeAsExposureRenderMakesIt() {
        const auto ways = accuracyWays(test::tissueScene(), "cpu");
        QCOMPARE(ways.size(), std::size_t(5));
        for (const AccuracyWay& way : ways) {
            const bool exact = way.name == "as it is" || way.name == "Exposure Render's order";
            QCOMPARE(way.bias.empty(), exact);
        }
        Scene bounces = test::tissueScene();
        bounces.model = Model::multipleScattering;
        QCOMPARE(accuracyWays(bounces, "cpu").size(), std::size_t(3));  // the march knows one event alone
        QCOMPARE(accuracyWays(test::tissueScene(), "cuda:0").back().bias, std::string("fast filter"));
    }
    void allModelsAndReconstructionsAreOtherImages() {
        const Scene scene = test::tissueScene();
        const auto others = otherImages(scene);
        QCOMPARE(others.size(), std::size(kModels));  // the others, and interpolated slices
        for (const AccuracyWay& other : others)
            QVERIFY(other.bias.empty() && other.scene.check() && !(other.scene == scene));
        QCOMPARE(otherImages(others.back().scene).size(), std::size(kModels) - 1);  // they are there already
    }
    /// Errors that fall as most do: the times foretold with a quarter and a sixteenth of the samples hold what came.
    void whatWasForetoldStandsBesideWhatCame() {
        Scene scene = test::tissueScene();
        const auto device = makeCpuDevice();
        const auto quiet = [](double, const std::string&) {};
        const auto reference = referenceFor(referenceScene(scene), 0.01, {}, *device, {}, quiet);
        QVERIFY(bool(reference));
        const AccuracyPlan plan{1, {}, {}, {}};
        const auto curves = measureAccuracy({"as it is", "", scene}, *reference->film, plan, *device, {}, quiet);
        QVERIFY(bool(curves) && curves->size() == 2);
        int foretold = 0;
        for (const AccuracyStep& step : (*curves)[0].steps) {
            QVERIFY(step.samples > 64 || !step.foretoldAtQuarter);  // 32 samples are the first to know an error
            foretold += step.foretoldAtQuarter.has_value();
            if (step.foretoldAtQuarter)
                QVERIFY(step.foretoldAtQuarter->low <= step.foretoldAtQuarter->value);
        }
        QVERIFY((*curves)[0].steps.back().samples < 128 || foretold > 0);
    }
    /// The reference of an earlier run, of the same scene, is gone on from; of any other it is not.
    void aReferenceIsKeptFromRunToRun() {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("reference.film").toStdString();
        const Scene scene = referenceScene(test::tissueScene());
        const auto device = makeCpuDevice();
        const auto quiet = [](double, const std::string&) {};
        const auto origin = [&](const Scene& of) { return *filmOrigin(of, *device, 1, 1); };
        const FilmOrigin own = origin(scene);
        const auto kept = [&] { return keptFilm(own, scene.revision, file); };
        QVERIFY(!kept());
        const auto first = referenceFor(scene, 0.05, {}, *device, {}, quiet);
        QVERIFY(first && keepFilm(*first, own, file));
        const auto again = kept();
        QVERIFY(again && again->seconds == first->seconds && sameBits(again->film->content(), first->film->content()));
        const auto same = referenceFor(scene, 0.05, again, *device, {}, quiet);
        QCOMPARE(same->film->samplesPerPixel(), first->film->samplesPerPixel());
        const auto longer = referenceFor(scene, 1.5 * first->seconds, again, *device, {}, quiet);
        const std::uint64_t samples = longer->film->samplesPerPixel();
        QVERIFY(samples > first->film->samplesPerPixel());
        QVERIFY(sameBits(longer->film->content(), test::render(scene, samples).content()));

        Scene other = scene;
        other.lights.clear();
        QVERIFY(origin(other) != own);
        other = scene;
        LabelMap map;
        map.geometry = scene.volume->geometry();
        map.labels.assign(map.geometry.voxelCount(), 1);
        other.parts = {std::make_shared<const LabelMap>(map), {{1, scene.transferFunction}}};
        const FilmOrigin parted = origin(other);
        other.parts.curves[0].transferFunction.extinctionPerMm *= 2;
        QVERIFY(parted != own && origin(other) != parted);
        map.labels[0] = 0;
        other.parts = {std::make_shared<const LabelMap>(map), {{1, scene.transferFunction}}};
        QVERIFY(origin(other) != parted);
        other = scene;
        other.volume = test::bumpyVolume({50, 41, 37}, {0.9, 1.1, 1.3}, 4);
        QVERIFY(origin(other) != own && !keptFilm(origin(other), scene.revision, file));
        const std::filesystem::path pipe = folder.filePath("pipe.film").toStdString();
        QVERIFY(::mkfifo(pipe.c_str(), 0600) == 0 && !keptFilm(own, scene.revision, pipe));  // and is not waited for
        QFile bytes(folder.filePath("reference.film"));
        QVERIFY(bytes.open(QIODevice::Append) && bytes.write("more") == 4);
        bytes.close();
        QVERIFY(!kept());
        std::filesystem::resize_file(file, std::filesystem::file_size(file) - 4);
        QVERIFY(kept().has_value());
        QVERIFY(bytes.open(QIODevice::ReadWrite) && bytes.seek(bytes.size() / 2) && bytes.write("damage") == 6);
        bytes.close();
        QVERIFY(!kept());
        std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
        QVERIFY(!kept());
    }
    void tableAndPageHoldTheSteps() {
        AccuracyReport report;
        report.scene.curves = {curveOf(20, 0.5), curveOf(10, 0.5, 12)};
        report.scene.curves[0].steps[3].stated = 9;
        report.scene.curves[0].steps[3].foretoldAtQuarter = Foretold{0.7, 0.6, INFINITY};
        report.scene.curves[1].measuredBias = MeasuredBias{{0.05, 0.04, 0.06}, {12, 10, 14}};
        report.others.push_back({"emission", 7, {}, {curveOf(20, 0.5)}});
        const QString csv = QString::fromStdString(csvText(report));
        QCOMPARE(csv.count('\n'), 22);
        QVERIFY(csv.contains("\"\",\"a way\",8,0.8,0.1,22.3607,9,\n"));
        const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(jsonText(report))).object();
        const QJsonObject way = json["ways"].toArray()[0].toObject();
        QCOMPARE(way["steps"].toArray().size(), 7);
        const QJsonObject foretold = way["steps"].toArray()[3].toObject()["foretoldAtQuarter"].toObject();
        QVERIFY(foretold["value"].toDouble() == 0.7 && foretold["high"].isNull());
        QCOMPARE(json["ways"].toArray()[1].toObject()["measuredBias"].toObject()["levels"].toObject()["high"], 14.0);
        QCOMPARE(json["others"].toArray()[0].toObject()["reference"].toObject()["samples"], 7);
        QVERIFY(std::fabs(way["secondsTo"].toObject()["16"].toDouble() - 1.5625) < 1e-9);
        QVERIFY(way["secondsTo"].toObject()["1"].isNull());
        const QString page = QString::fromStdString(pageText(report, {}));
        QVERIFY(page.contains("<svg") && page.contains("never after"));
        QVERIFY(page.contains("at least 0.6 s") && page.contains("+5.0 % bright") && page.contains("emission"));
        QVERIFY(!page.contains("nan") && !page.contains("inf"));
    }
};

QTEST_GUILESS_MAIN(AccuracyCurveTest)
#include "accuracy_curve_test.moc"
