#include "tests/support/scenes/tissue_scene.h"  // before Qt, whose word "emit" TBB uses

#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <random>

#include "app/cli/batch/joined_films.h"
#include "render/film/tile_progress.h"
#include "tests/support/program_run.h"

using namespace pdr;
using namespace pdr::app;

/// Shares of an image that machines render alone, and the image that is made of their films.
class SharesTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;
    Scene scene_ = test::tissueScene();
    std::unique_ptr<Device> device_ = makeCpuDevice(2);

    std::filesystem::path at(const QString& name) const { return folder_.filePath(name).toStdString(); }

    /// Renders a share of `scene` and writes its film to "NUMBER.film".
    std::filesystem::path rendered(const Scene& scene, const Share& share, std::uint32_t samples) {
        SavedFilm saved{*filmOrigin(scene, *device_, samples, share.of), {{share.number, 1, {}, {}, {}}}};
        if (!device_->upload(scene))
            qFatal("the scene cannot be rendered");
        for (const Tile& tile : tilesOf(share, scene.film)) {
            const auto film = *device_->film(tile, scene.revision, scene.schedule);
            for (std::uint32_t done = 0; done < samples; done += 30)  // ends within blocks, too
                if (!film->accumulate(std::min(30u, samples - done), {}))
                    qFatal("the share cannot be rendered");
            addTile(saved.shares.front(), **film->film());
        }
        const std::filesystem::path file = at(QString("%1-%2.film").arg(scene.seed).arg(share.number));
        if (!writeFilm(saved, file))
            qFatal("the film cannot be written");
        return file;
    }
    static QString textOf(const Result<SavedFilm>& result) {
        return result ? QString() : QString::fromStdString(result.error().text());
    }

  private slots:
    /// Every pixel belongs to one share, and no share has more than a cell more than another.
    void sharesCoverTheImageOnce() {
        for (const ivec2 size : {ivec2(1, 1), ivec2(16, 16), ivec2(17, 200), ivec2(333, 40), ivec2(640, 360)})
            for (const int of : {1, 2, 3, 7, 64, mostShares(size)}) {
                if (of > mostShares(size))
                    continue;
                std::vector<int> owners(std::size_t(size.x) * std::size_t(size.y));
                std::vector<int> cells;
                for (int number = 1; number <= of; ++number) {
                    cells.push_back(0);
                    for (const Tile& tile : tilesOf({number, of}, size)) {
                        QVERIFY(tile.width > 0 && tile.height > 0 && isInside(tile, wholeImage(size)));
                        QVERIFY(TileProgress(wholeImage(size)).isWholeCells(tile));
                        cells.back() += cellsIn(tile.width) * cellsIn(tile.height);
                        for (int y = tile.y; y < tile.y + tile.height; ++y)
                            for (int x = tile.x; x < tile.x + tile.width; ++x)
                                ++owners[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
                    }
                }
                QVERIFY(std::ranges::all_of(owners, [](int count) { return count == 1; }));
                QVERIFY(std::ranges::max(cells) - std::ranges::min(cells) <= 1);
            }
    }

    void wordsThatAreNoShare() {
        QVERIFY(readShare("3/200") && *readShare("3/200") == (Share{3, 200}));
        for (const char* word : {"", "3", "3/", "/3", "0/3", "4/3", "-1/3", "1/3x", "1 /3", "1/99999999999"})
            QVERIFY2(!readShare(word), word);
    }

    /// The film of all shares, joined in any order and as a tree, has the bits of one machine's.
    void joinedSharesAreTheFilm() {
        constexpr int kShares = 7;
        constexpr std::uint32_t kSamples = 100;
        std::vector<std::filesystem::path> files;
        for (int number = 1; number <= kShares; ++number)
            files.push_back(rendered(scene_, {number, kShares}, kSamples));
        const FilmContent one = test::render(scene_, kSamples).content();
        std::mt19937 random(3);
        for (int turn = 0; turn < 3; ++turn) {
            std::shuffle(files.begin(), files.end(), random);
            const auto joined = joinedFilms(files);
            QVERIFY(joined && checkComplete(*joined));
            const auto film = wholeFilm(*joined, scene_.revision);
            QVERIFY(sameBits(film->content(), one));
            QVERIFY(film->samplesPerPixel() == kSamples && film->content().progress == one.progress);
        }
        const auto some = joinedFilms({files[4], files[0], files[5]});
        QVERIFY(some && writeFilm(*some, at("some.film")));
        const auto tree = joinedFilms({files[1], at("some.film"), files[2], files[6], files[3]});
        QVERIFY(tree && checkComplete(*tree) && sameBits(wholeFilm(*tree, 1)->content(), one));
        QVERIFY(joinedFilms({files[1], at("some.film"), files[0]}).error().text().find(at("some.film").string()) !=
                std::string::npos);
    }

    void whatIsMissingOrForeignIsNamed() {
        const auto first = rendered(scene_, {1, 9}, 4), third = rendered(scene_, {3, 9}, 4);
        const auto two = joinedFilms({third, first});
        QVERIFY(two);
        QCOMPARE(QString::fromStdString(checkComplete(*two).error().text()),
                 QString("7 of 9 shares are missing: 2, 4 to 9. Render them, and name their files, too."));
        QVERIFY(textOf(joinedFilms({first, third, first})).contains("share 1 is in"));

        Scene other = scene_;
        other.seed = 77;
        QVERIFY(textOf(joinedFilms({first, rendered(other, {2, 9}, 4)})).contains("from another seed"));
        QVERIFY(textOf(joinedFilms({first, rendered(scene_, {2, 9}, 5)})).contains("another number of samples"));
        QVERIFY(textOf(joinedFilms({first, rendered(scene_, {2, 8}, 4)})).contains("another number of shares"));
        other = scene_;
        other.lights.pop_back();
        QVERIFY(textOf(joinedFilms({first, rendered(other, {2, 9}, 4)})).contains("another scene"));
        other = scene_;
        other.volume = test::bumpyVolume({50, 41, 37}, {0.9, 1.1, 1.3}, 4);
        QVERIFY(textOf(joinedFilms({first, rendered(other, {2, 9}, 4)})).contains("another scan"));
        other = scene_;
        other.film.x += 1;
        QVERIFY(textOf(joinedFilms({first, rendered(other, {2, 9}, 4)})).contains("another size"));
    }

    /// A file with one bit changed, cut off, or longer is refused, wherever it is changed.
    void damagedFilmsAreRefused() {
        const auto path = rendered(scene_, {2, 9}, 4);
        QFile file(QString::fromStdString(path.string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        file.close();
        const auto isRefused = [&](const QByteArray& bytes) {
            QFile changed(folder_.filePath("changed.film"));
            if (!changed.open(QIODevice::WriteOnly) || changed.write(bytes) != bytes.size())
                qFatal("the test cannot write its files");
            changed.close();
            return !readFilm(at("changed.film"));
        };
        QVERIFY(!isRefused(whole));
        std::mt19937 random(9);
        for (int at = 0; at < 400; ++at) {
            QByteArray changed = whole;
            const auto place = at < 200 ? qsizetype(at) : qsizetype(random() % std::uint32_t(whole.size()));
            if (place < whole.size()) {
                changed[place] = char(changed[place] ^ (1 << random() % 8));
                QVERIFY2(isRefused(changed), qPrintable(QString::number(place)));
            }
        }
        for (const qsizetype length : {qsizetype(0), qsizetype(7), qsizetype(150), whole.size() / 2, whole.size() - 1})
            QVERIFY(isRefused(whole.left(length)));
        QVERIFY(isRefused(whole + "x"));
        QVERIFY(!readFilm(at("absent.film")));
    }

    /// The program's own images: those of one run, and those of three whose films are merged.
    void imagesOfSharesAreThoseOfOneRun() {
        QByteArray said;
        const auto run = [&](const QString& words) {
            const test::ProgramRun ended = test::runProgram("pdrender-cli", words.split(' '), [&](QProcess& process) {
                process.setWorkingDirectory(folder_.path());
            });
            said = ended.err;
            return ended.code;
        };
        QCOMPARE(run("example head"), 0);
        const QString options = " head --size 90x70 --exposure auto --denoised --annotations none";
        QCOMPARE(run("render" + options + " --samples 20 -o one.png"), 0);
        for (const char* share : {"1", "2", "3"})
            QCOMPARE(run(QString("render head --size 90x70 --samples 20 --share %1/3 -o %1.film").arg(share)), 0);
        QCOMPARE(run("merge" + options + " 3.film 1.film 2.film -o all.png"), 0);
        QVERIFY(QImage(folder_.filePath("one.png")) == QImage(folder_.filePath("all.png")));
        QVERIFY(!QImage(folder_.filePath("all.png")).isNull());

        QCOMPARE(run("merge" + options + " 3.film 1.film -o none.png"), 1);
        QVERIFY(said.contains("1 of 3 shares are missing: 2"));
        QCOMPARE(run("merge" + options + " --seed 9 3.film 1.film 2.film -o none.png"), 1);
        QVERIFY(said.contains("from another seed"));
        QCOMPARE(run("render head --share 1/3 --levels 8 -o 1.film"), 2);
        QCOMPARE(run("render head --share 1/3 -o 1.png"), 2);
        QCOMPARE(run("render head --size 16x16 --share 1/3 -o 1.film"), 1);
        QCOMPARE(run("merge 1.film 2.film -o all.png"), 2);
        QVERIFY(!QFile::exists(folder_.filePath("none.png")));
    }
};

QTEST_GUILESS_MAIN(SharesTest)
#include "shares_test.moc"
