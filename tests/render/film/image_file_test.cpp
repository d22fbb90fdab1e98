#include <QtTest>

#include <ImfChannelList.h>
#include <ImfChromaticitiesAttribute.h>
#include <ImfDoubleAttribute.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <QImage>
#include <QTemporaryDir>

#include <csignal>
#include <fstream>

#include "render/film/display/tone_map.h"
#include "render/film/error/likely_error.h"
#include "render/film/error/local_error.h"
#include "render/film/file/image_file.h"
#include "tests/support/exr_channels.h"
#include "tests/support/scenes/noisy_films.h"

using namespace pdr;

static Health someFaults() {
    Health health;
    health.add(Fault::infinite, 7, 11);
    health.add(Fault::infinite, 9, 2);
    health.add(Fault::negative, 3, 4);
    health.add(Fault::cutPath, 1, 1);
    return health;
}

static Provenance someFacts() {
    Provenance facts{.exposure = 4,
                     .seconds = 1.5,
                     .seed = 18446744073709551615u,
                     .model = "singleScattering",
                     .extinctionPerMm = 2.5,
                     .program = "PD-Render 0.1.0",
                     .device = "cpu",
                     .effects = "shadows, highlights",
                     .look = "Bone",
                     .camera = "{}"};
    facts.status.samplesPerPixel = 128;
    facts.status.relativeError = 0.025;
    facts.status.displayError = 9;
    facts.status.unseenTissue = 0.125;
    facts.status.health = someFaults();
    return facts;
}
static const Provenance kFacts = someFacts();

/// Two samples a pixel, so that means and standard errors are known.
static Film exampleFilm(ivec2 size) {
    Film film(size, 0);
    TileSums sums = film.sums(wholeImage(size));
    for (int i = 0; i < size.x * size.y; ++i) {
        const dvec3 a(i, 0.5 * i, 1), b(i + 1, 0.5 * i + 2, 1);
        sums.pixels[i] = {.sum = a + b, .sumOfSquares = a * a + b * b, .count = 2};
    }
    film.commit({0, 2});
    return film;
}

static QByteArray contents(const std::filesystem::path& path) {
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

class ImageFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    std::filesystem::path at(const char* name) const { return folder_.filePath(name).toStdString(); }
    QStringList names() const {
        return QDir(folder_.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot);
    }

  private slots:
    void cleanup() {
        for (const QString& name : names())
            std::filesystem::remove_all(at(name.toUtf8().constData()));
    }

    void pngHoldsTheToneMappedFilmAndItsProvenance() {
        const Film film = exampleFilm({7, 5});
        QVERIFY(bool(writePng(film, {4}, kFacts, at("a.png"))));
        const QImage image(folder_.filePath("a.png"));
        const auto rgba = toneMap(film, {4});
        QCOMPARE(image.size(), QSize(7, 5));
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x) {
                const std::uint8_t* level = &rgba[std::size_t(y * 7 + x) * 4];
                QCOMPARE(image.pixel(x, y), qRgb(level[0], level[1], level[2]));
            }
        QCOMPARE(image.text("pdrender/samplesPerPixel"), QString("128"));
        QCOMPARE(image.text("pdrender/seconds"), QString("1.5"));
        QCOMPARE(image.text("pdrender/relativeError"), QString("0.025"));
        QCOMPARE(image.text("pdrender/seed"), QString("18446744073709551615"));
        QCOMPARE(image.text("pdrender/model"), QString("singleScattering"));
        QCOMPARE(image.text("pdrender/extinctionPerMm"), QString("2.5"));
        QCOMPARE(image.text("Software"), QString("PD-Render 0.1.0"));
        QCOMPARE(image.text("pdrender/tissueWithinLevels"), QString("9"));
        QCOMPARE(image.text("pdrender/tissueNotSeenYet"), QString("0.125"));
        QCOMPARE(image.text("pdrender/exposure"), QString("4"));
        QCOMPARE(image.text("pdrender/bias"), QString("none known"));
        QCOMPARE(image.text("pdrender/device"), QString("cpu"));
        QCOMPARE(image.text("pdrender/effects"), QString("shadows, highlights"));
        QCOMPARE(image.text("pdrender/look"), QString("Bone"));
        QCOMPARE(image.text("pdrender/camera"), QString("{}"));
    }

    void whatIsPaintedOverItStandsInIt() {
        const Film film = exampleFilm({7, 5});
        QVERIFY(bool(writePng(film, {4}, kFacts, at("a.png"))));
        const QImage plain(folder_.filePath("a.png"));
        const PaintOver paintOver = [](ivec2 size, std::vector<std::uint8_t>& rgba) {
            QVERIFY(size == ivec2(7, 5));
            std::fill_n(rgba.begin() + (1 * 7 + 2) * 4, 3, std::uint8_t(255));
        };
        QVERIFY(bool(writePng(film, {4}, kFacts, at("a.png"), paintOver)));
        const QImage painted(folder_.filePath("a.png"));
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x)
                QCOMPARE(painted.pixel(x, y), x == 2 && y == 1 ? qRgb(255, 255, 255) : plain.pixel(x, y));
    }

    /// An image leaves the program without its status line.
    void aDenoisedPngSaysSoAndHowFarItIs() {
        const Film film = test::noisyFilmOf(
            {96, 64}, [](int x, int) { return 0.2 + 0.005 * x; }, 16);
        const FilmContent before = film.content();
        const auto text = [&](const pdr::Display& display) {
            (void)writePng(film, display, kFacts, at("a.png"));
            return QImage(folder_.filePath("a.png")).text("pdrender/denoised");
        };
        QVERIFY(text({1, false}).isEmpty());
        const QImage raw(folder_.filePath("a.png"));
        QVERIFY2(
            QRegularExpression("^95 % of the tissue within [0-9.]+ of 255 levels; lines of 2 pixels below [0-9]+ % "
                               "contrast may be missing$")
                .match(text({1, true}))
                .hasMatch(),
            qPrintable(text({1, true})));
        const QImage denoised(folder_.filePath("a.png"));
        const std::vector<std::uint8_t> shown = toneMap(film, {1, true});
        QCOMPARE(denoised.pixel(5, 0), qRgb(shown[20], shown[21], shown[22]));
        QVERIFY(raw != denoised);
        QVERIFY(sameBits(before, film.content()));
    }

    /// The one line that the film has and the image has not.
    void aDenoisedPngSaysHowManyLinesAreMissing() {
        const auto line = [](int x, int y) { return x < 80 && (y == 30 || y == 31) ? 0.38 : 0.5; };
        (void)writePng(test::noisyFilmOf({96, 64}, line, 16), {1, true}, kFacts, at("a.png"));
        const QString text = QImage(folder_.filePath("a.png")).text("pdrender/denoised");
        QVERIFY2(text.endsWith("; 1 line of the film missing"), qPrintable(text));
    }

    void aBiasedEstimatorIsSaid() {
        const Film film = exampleFilm({2, 2});
        QVERIFY(bool(writePng(film, {4}, kFacts, at("a.png"))));
        QVERIFY(!QImage(folder_.filePath("a.png")).textKeys().contains("pdrender/estimator"));
        Provenance biased = kFacts;
        biased.estimator = "kroesMarch (biased)";
        QVERIFY(bool(writePng(film, {4}, biased, at("a.png"))) && bool(writeExr(film, biased, at("a.exr"))));
        QCOMPARE(QImage(folder_.filePath("a.png")).text("pdrender/estimator"), QString("kroesMarch (biased)"));
        Imf::InputFile file(at("a.exr").c_str());
        QCOMPARE(file.header().typedAttribute<Imf::StringAttribute>("pdrender/estimator").value(),
                 "kroesMarch (biased)");
    }

    void exrComesBackAsItWasWritten() {
        const Film film = exampleFilm({7, 5});
        QVERIFY(bool(writeExr(film, kFacts, at("b.exr"))));
        const auto image = readExr(at("b.exr"));
        QVERIFY(image && image->size == ivec2(7, 5));
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x)
                QVERIFY(image->pixels[y * 7 + x] == vec3(film.pixel(x, y).mean));
        QVERIFY(!readExr(at("no such file.exr")));
        QVERIFY(::mkfifo(at("pipe.exr").c_str(), 0600) == 0 && !readExr(at("pipe.exr")));  // and is not waited for
        QFile file(QString::fromStdString(at("b.exr")));
        QVERIFY(file.open(QIODevice::ReadWrite) && file.resize(file.size() / 2));
        QVERIFY(!readExr(at("b.exr")));
        QVERIFY(file.resize(0) && !readExr(at("b.exr")));
    }

    /// The file is refused before memory is allocated for the size that it claims to have.
    void whatClaimsToBeLargerThanItIsIsRefused() {
        QVERIFY(bool(writeExr(exampleFilm({7, 5}), kFacts, at("c.exr"))));
        QFile file(QString::fromStdString(at("c.exr")));
        QVERIFY(file.open(QIODevice::ReadWrite));
        QByteArray bytes = file.readAll();
        const QByteArray corner("\xFF\x3F\0\0\xFF\x3F\0\0", 8);  // 16383, 16383
        for (const char* window : {"dataWindow", "displayWindow"}) {
            const qsizetype at = bytes.indexOf(QByteArray(window) + '\0' + "box2i");
            QVERIFY(at > 0);
            bytes.replace(at + qsizetype(qstrlen(window)) + 7 + 4 + 8, 8, corner);
        }
        bytes += QByteArray(20000, '\0');  // where it says that its lines are: nowhere
        QVERIFY(file.seek(0) && file.write(bytes) == bytes.size() && file.flush());
        rlimit before{};
        ::getrlimit(RLIMIT_AS, &before);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        const rlimit little{rlim_t(1) << 30, before.rlim_max};  // the image that it claims to be takes 3.2 GB
        ::setrlimit(RLIMIT_AS, &little);
#endif
        const auto refused = readExr(at("c.exr"));
        ::setrlimit(RLIMIT_AS, &before);
        QVERIFY(!refused);
        QVERIFY2(refused.error().what == "the image is not complete", refused.error().text().c_str());
    }

    /// A file is read piece by piece, so that reading can be cancelled.
    void exrIsReadPieceByPiece() {
        const Film film = exampleFilm({3, 700});
        QVERIFY(bool(writeExr(film, kFacts, at("b.exr"))));
        int pieces = 0;
        const auto image = readExr(at("b.exr"), [&](double fraction, std::string_view) {
            ++pieces;
            return fraction >= 0 && fraction < 1;
        });
        QVERIFY(image && pieces > 1);
        for (int y = 0; y < 700; ++y)
            QVERIFY(image->pixels[std::size_t(y) * 3 + 2] == vec3(film.pixel(2, y).mean));
        const auto stopped = readExr(at("b.exr"), [](double fraction, std::string_view) { return fraction < 0.5; });
        QVERIFY(!stopped && stopped.error().kind == ErrorKind::cancelled);
    }

    void exrHoldsMeanErrorBoundAndProvenance() {
        const Film film = test::noisyFilmOf(
            {7, 5}, [](int x, int y) { return 0.1 * (1 + x) + y; }, 16);
        QVERIFY(bool(writeExr(film, kFacts, at("a.exr"))));
        Imf::InputFile file(at("a.exr").c_str());
        const Imf::Header& header = file.header();
        QCOMPARE(header.typedAttribute<Imf::DoubleAttribute>("pdrender/samplesPerPixel").value(), 128.0);
        QCOMPARE(header.typedAttribute<Imf::DoubleAttribute>("pdrender/relativeError").value(), 0.025);
        QCOMPARE(header.typedAttribute<Imf::DoubleAttribute>("pdrender/tissueWithinLevels").value(), 9.0);
        QCOMPARE(header.typedAttribute<Imf::StringAttribute>("pdrender/camera").value(), "{}");
        QCOMPARE(header.typedAttribute<Imf::DoubleAttribute>("pdrender/rejectedSamples").value(), 3.0);
        QCOMPARE(header.typedAttribute<Imf::StringAttribute>("pdrender/health").value(),
                 "notANumber 0, infinite 2 (pixel 11, sample 7), negative 1 (pixel 4, sample 3), overMajorant 0, "
                 "cutPath 1 (pixel 1, sample 1), overTolerance 0");
        QCOMPARE(header.typedAttribute<Imf::DoubleAttribute>("renderTimeSeconds").value(), 1.5);
        QCOMPARE(header.typedAttribute<Imf::StringAttribute>("pdrender/seed").value(), "18446744073709551615");
        QCOMPARE(header.typedAttribute<Imf::StringAttribute>("pdrender/program").value(), "PD-Render 0.1.0");
        QCOMPARE(header.typedAttribute<Imf::ChromaticitiesAttribute>("chromaticities").value().red.x, 0.64f);

        const std::vector<float> values = test::exrValues(at("a.exr"));
        QCOMPARE(values.size(), std::size_t(7 * 5 * 9));
        const denoise::Colours errors = likelyErrors(film, wholeImage(film.size())), bounds = localErrors(film);
        for (int y = 0; y < 5; ++y)
            for (int x = 0; x < 7; ++x) {
                const PixelEstimate pixel = film.pixel(x, y);
                for (int c = 0; c < 3; ++c) {
                    const float* of = &values[(y * 7 + x) * 9 + c];
                    QCOMPARE(of[0], float(pixel.mean[c]));
                    QCOMPARE(of[3], errors[c].row(y)[x]);
                    QCOMPARE(of[6], bounds[c].row(y)[x]);
                    QVERIFY(of[3] <= of[6]);
                }
            }
    }

    void anotherRenderersScheduleIsSaid() {
        const Film film = exampleFilm({2, 2});
        QVERIFY(bool(writePng(film, {4}, kFacts, at("a.png"))));
        QVERIFY(!QImage(folder_.filePath("a.png")).textKeys().contains("pdrender/schedule"));
        Provenance compared = kFacts;
        compared.schedule = "Exposure Render's K1, blurred";
        QVERIFY(bool(writePng(film, {4}, compared, at("a.png"))) && bool(writeExr(film, compared, at("a.exr"))));
        QCOMPARE(QImage(folder_.filePath("a.png")).text("pdrender/schedule"), "Exposure Render's K1, blurred");
        Imf::InputFile file(at("a.exr").c_str());
        QCOMPARE(file.header().typedAttribute<Imf::StringAttribute>("pdrender/schedule").value(),
                 "Exposure Render's K1, blurred");
    }

    void sameFilmSameBytes() {
        const Film film = exampleFilm({16, 16});
        QVERIFY(bool(writeExr(film, kFacts, at("a.exr"))) && bool(writeExr(film, kFacts, at("b.exr"))));
        QVERIFY(bool(writePng(film, {1}, kFacts, at("a.png"))) && bool(writePng(film, {1}, kFacts, at("b.png"))));
        QCOMPARE(contents(at("a.exr")), contents(at("b.exr")));
        QCOMPARE(contents(at("a.png")), contents(at("b.png")));
    }

    void anOldImageIsReplaced() {
        std::ofstream(at("a.png")) << "old";
        QVERIFY(bool(writePng(exampleFilm({4, 4}), {1}, kFacts, at("a.png"))));
        QVERIFY(!QImage(folder_.filePath("a.png")).isNull());
        QCOMPARE(names(), QStringList{"a.png"});
    }

    void aMissingFolderIsNamed() {
        const auto ok = writePng(exampleFilm({4, 4}), {1}, kFacts, at("none/a.png"));
        QVERIFY(!ok);
        QCOMPARE(ok.error().where, at("none/a.png").string());
        QVERIFY(ok.error().hint.find("Create the folder") != std::string::npos);
    }

    void aFolderIsNoFile() {
        std::filesystem::create_directory(at("a.png"));
        QVERIFY(!writePng(exampleFilm({4, 4}), {1}, kFacts, at("a.png")));
        QVERIFY(!writeExr(exampleFilm({4, 4}), kFacts, at("a.png")));
        QCOMPARE(names(), QStringList{"a.png"});
    }

    void whatIsStoppedLeavesTheOldImage() {
        std::ofstream(at("a.png")) << "old";
        std::stop_source stop;
        stop.request_stop();
        const Film film = exampleFilm({30, 30});
        const auto png = writePng(film, {1, true}, kFacts, at("a.png"), {}, stop.get_token());
        const auto exr = writeExr(film, kFacts, at("a.exr"), stop.get_token());
        QVERIFY(!png && png.error().kind == ErrorKind::cancelled);
        QVERIFY(!exr && exr.error().kind == ErrorKind::cancelled);
        QCOMPARE(names(), QStringList{"a.png"});
        QCOMPARE(contents(at("a.png")), QByteArray("old"));
    }

    /// A limit on the size of files fails the write as a full disk does.
    void afterAFullDiskTheOldImageIsStillThere() {
        std::ofstream(at("a.png")) << "old";
        std::ofstream(at("a.exr")) << "old";
        const Film film = exampleFilm({300, 300});
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small{2000, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
        const auto png = writePng(film, {3e4f}, kFacts, at("a.png"));
        const auto exr = writeExr(film, kFacts, at("a.exr"));
        setrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, oldHandler);
        QVERIFY(!png && !exr);
        QVERIFY2(png.error().hint.find("Make room") != std::string::npos, png.error().text().c_str());
        QVERIFY2(exr.error().hint.find("Make room") != std::string::npos, exr.error().text().c_str());
        QCOMPARE(names(), (QStringList{"a.exr", "a.png"}));
        QCOMPARE(contents(at("a.png")), QByteArray("old"));
        QCOMPARE(contents(at("a.exr")), QByteArray("old"));
    }
};

QTEST_APPLESS_MAIN(ImageFileTest)
#include "image_file_test.moc"
