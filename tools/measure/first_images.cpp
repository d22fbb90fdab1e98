/// Measures how good the image is soon after an edit, in the real window: the image after 0.1, 1 and 10 seconds,
/// denoised and raw, against an image of many samples of another seed.
///   first_images FOLDER [-o SHEET.jpg] [--reference N] [--threads N] [--look NAME]
///                [--edit KIND:AMOUNT [--film N] [--json FILE]] [--window W,H] [--labels FILE] [--each]
/// FOLDER holds a CT, and a label map may mark parts of it, which a look may show. The edit is a view from the front.
/// Prints a line for each image: its samples and pixels, the levels of 255 within which 95 % of the tissue are once the
/// image is stretched to the view as the window does, and the error that the window states. With -o the images are
/// drawn on one sheet: raw above, denoised below, the reference on the right. No film is kept, so that none of this
/// view comes back. With --each it prints when each image came, and of how many samples. With --edit the look is edited
/// instead (edit_trial.h), once the film has N samples (default 256): the images after 1, 4, 16 and 64 samples, and
/// those in the window after 0.1, 1 and 10 seconds; each with the error of the change over tiles of 16 x 16 pixels, in
/// parts of the mean change. Their sheet: those of the window above, the image before the edit and new samples alone
/// below, denoised, the reference on the right.

#include <QApplication>
#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonDocument>
#include <QPainter>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <array>
#include <cstdio>

#include "app/desktop/desktop.h"
#include "app/looks/looks.h"
#include "app/presenters/parts_presenter.h"
#include "render/film/display/tone_map.h"
#include "tools/measure/edit_trial.h"
#include "ui/theme/theme.h"

namespace pdr::app {
namespace {

constexpr std::array<double, 3> kSeconds{0.1, 1, 10};

struct Plan {
    QString folder, out, look;
    int reference, threads;
    QString edit, json;  ///< edit: empty: another view
    int film;
    QSize window;    ///< empty: the usual size
    QString labels;  ///< a label map; empty: none
    bool each;       ///< print when each image comes
};

using Shown = std::shared_ptr<const Frame>;

QImage imageOf(const std::vector<std::uint8_t>& rgba, ivec2 size) {
    return QImage(rgba.data(), size.x, size.y, 4 * size.x, QImage::Format_RGBA8888)
        .convertToFormat(QImage::Format_RGB32);
}

/// Returns the image stretched to the view, as the window does.
QImage stretched(const QImage& image, QSize view) {
    if (image.size() == view)
        return image;
    QImage out(view, QImage::Format_RGB32);
    QPainter painter(&out);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.drawImage(QRectF(QPointF(0, 0), QSizeF(view)), image);
    return out;
}

QString said(const Frame& frame) {
    if (frame.denoised && frame.denoisedError)
        return QString("said: ±%1, at most ±%2")
            .arg(frame.denoisedError->levels, 0, 'f', 1)
            .arg(frame.denoisedError->levelsAtMost, 0, 'f', 1);
    if (!frame.denoised && std::isfinite(frame.status.displayError))
        return QString("said: ±%1").arg(frame.status.displayError, 0, 'f', 1);
    return "nothing said yet";
}

/// Prints when an image came after an edit, and what it is of.
void tell(const Frame& frame, double seconds) {
    std::printf("%7.3f s  %4d x %-4d pixels  %4llu samples  %-8s  %s\n", seconds, frame.size.x, frame.size.y,
                (unsigned long long)frame.status.samplesPerPixel, frame.denoised ? "denoised" : "raw",
                said(frame).toUtf8().constData());
}

/// The images on the screen kSeconds after an edit; `each`: tells of all.
std::array<Shown, kSeconds.size()> shownAfter(Desktop& desktop, bool each, const std::function<void()>& edit) {
    QElapsedTimer clock;
    clock.start();
    QObject context;
    if (each)
        QObject::connect(&desktop.bridge(), &RenderBridge::frameReady, &context,
                         [&](const Shown& frame) { tell(*frame, 1e-3 * double(clock.elapsed())); });
    edit();
    const std::uint64_t revision = desktop.document().scene().revision;
    std::array<Shown, kSeconds.size()> shown;
    for (std::size_t i = 0; i < kSeconds.size(); ++i) {
        QTest::qWait(std::max(0, int(1e3 * kSeconds[i] - double(clock.elapsed()))));
        if (const Shown& last = desktop.bridge().lastFrame(); last && last->revision == revision)
            shown[i] = last;
    }
    return shown;
}

/// The images on the screen kSeconds after a view from the front, which comes after one from the left.
std::array<Shown, kSeconds.size()> shownAfterView(Desktop& desktop, bool each) {
    desktop.document().setView(StandardView::left);
    QTest::qWait(3000);
    return shownAfter(desktop, each, [&] { desktop.document().setView(StandardView::anterior); });
}

/// An image that was on the screen, with a text below it: its true error, and the stated one.
struct Trial {
    QString text;
    QImage image;
};

Trial trialOf(const char* kind, double seconds, const Shown& shown, const QImage& truth, const Film& tissue) {
    const QString name = QString("%1, %2 s").arg(kind).arg(seconds);
    if (!shown)
        return {name + ": no image yet", {}};
    const QImage image = stretched(imageOf(shown->rgba, shown->size), truth.size());
    const int levels = levelsOff(image, truth, tissue);
    std::printf("%-14s %4d x %-4d pixels  %4llu samples  95 %% of the tissue within %3d levels  %s\n", qPrintable(name),
                shown->size.x, shown->size.y, (unsigned long long)shown->status.samplesPerPixel, levels,
                said(*shown).toUtf8().constData());
    return {QString("%1: ±%2\n%3").arg(name).arg(levels).arg(said(*shown)), image};
}

/// The part of the image with tissue, and a margin.
QRect tissueIn(const Film& film) {
    QRect box;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x)
            if (film.pixel(x, y).tissue)
                box |= QRect(x, y, 1, 1);
    return box.adjusted(-8, -8, 8, 8) & QRect(0, 0, film.size().x, film.size().y);
}

/// Two rows of images, and one on the right.
QImage sheetOf(const std::vector<Trial>& trials, const Trial& reference, const QRect& part) {
    constexpr int kText = 40, kGap = 6;
    const QSize cell(part.width() + kGap, part.height() + kText + kGap);
    const int columns = int(trials.size()) / 2;
    QImage sheet(cell.width() * (columns + 1), 2 * cell.height(), QImage::Format_RGB32);
    sheet.fill(Qt::white);
    QPainter painter(&sheet);
    const auto draw = [&](const Trial& trial, int column, double row) {
        const QPoint at(column * cell.width(), int(row * cell.height()));
        painter.drawImage(at, trial.image, part);
        painter.drawText(QRect(at + QPoint(2, part.height()), QSize(part.width(), kText)), Qt::AlignTop, trial.text);
    };
    for (int i = 0; i < int(trials.size()); ++i)
        draw(trials[std::size_t(i)], i % columns, i / columns);
    draw(reference, columns, 0.5);
    return sheet;
}

/// Nothing: it could not be made.
std::shared_ptr<const Film> referenceOf(Scene scene, const Plan& plan) {
    scene.seed += 777'000'777;  // neighbouring seeds share half their numbers
    const std::unique_ptr<Device> device = makeCpuDevice(plan.threads);
    const auto live = startFilm(*device, scene);
    if (!live || !(*live)->accumulate(std::uint32_t(plan.reference), {}))
        return nullptr;
    return *(*live)->film();
}

/// Waits until the film has so many samples, whatever its error is, and its image was judged.
bool waitForFilm(Desktop& desktop, int samples) {
    desktop.bridge().setStop({});
    const bool grown = QTest::qWaitFor(
        [&] {
            const Shown& last = desktop.bridge().lastFrame();
            return last && last->revision == desktop.document().scene().revision && !last->coarse &&
                   last->status.samplesPerPixel >= std::uint64_t(samples);
        },
        600'000);
    desktop.bridge().setPaused(true);
    QTest::qWait(3000);
    desktop.bridge().setPaused(false);
    return grown;
}

/// Returns the errors in a row of EditTrial's.
QString errorsOf(const QJsonValue& row) {
    return QString("±%1, change off by %2").arg(row["levels"].toInt()).arg(row["change"].toDouble(), 0, 'f', 2);
}

/// Measures the images after an edit of the look, made from films and as the window shows them.
int runEdit(Desktop& desktop, const Plan& plan) {
    desktop.document().setView(StandardView::anterior);
    const auto look = editedLook(desktop.document().setup().look, plan.edit);
    const auto clip = editedClip(desktop.document().scene().clip, desktop.document().scene().camera, plan.edit);
    if ((!look && !clip) || !waitForFilm(desktop, plan.film)) {
        std::printf("no such edit, or no film of %d samples\n", plan.film);
        return 1;
    }
    const Scene before = desktop.document().scene();
    const auto shown = shownAfter(
        desktop, plan.each, [&] { look ? desktop.document().setLook(*look) : desktop.document().setClip(*clip); });
    const Display display = desktop.document().display().withDenoised(true);
    const Scene after = desktop.document().scene();
    desktop.bridge().setPaused(true);
    const auto film = referenceOf(after, plan);
    if (!film)
        return 1;
    const QImage truth = imageOf(imageOf(*film, display).rgba, after.film);
    std::printf("%s, %s, %s from a film of %d samples: view of %d x %d pixels\n", qPrintable(plan.folder),
                qPrintable(plan.look), qPrintable(plan.edit), plan.film, after.film.x, after.film.y);
    EditTrial trial(truth, film, display);
    QJsonArray rows = trial.run(before, after, std::uint64_t(plan.film), plan.threads);
    std::vector<Trial> trials;
    for (std::size_t i = 0; i < kSeconds.size(); ++i) {
        const QImage image = shown[i] ? stretched(imageOf(shown[i]->rgba, shown[i]->size), truth.size()) : QImage();
        rows.append(trial.inWindow(kSeconds[i], image, shown[i].get()));
        trials.push_back({QString("in the window, %1 s\n%2").arg(kSeconds[i]).arg(errorsOf(rows.last())), image});
    }
    for (const EditTrial::Kept& kept : trial.kept())
        trials.push_back({kept.name + "\n" + errorsOf(kept.row), kept.image});
    const Trial reference{QString("reference: %1 samples").arg(plan.reference), truth};
    if (!plan.out.isEmpty() && !sheetOf(trials, reference, tissueIn(*film)).save(plan.out, nullptr, 88))
        return 1;
    if (QFile json(plan.json); !plan.json.isEmpty() && json.open(QIODevice::WriteOnly))
        json.write(QJsonDocument(QJsonObject{{"edit", plan.edit},
                                             {"look", plan.look},
                                             {"film", plan.film},
                                             {"width", after.film.x},
                                             {"height", after.film.y},
                                             {"images", rows}})
                       .toJson());
    return 0;
}

int run(const Plan& plan) {
    QTemporaryDir settings;
    Desktop desktop(*bundledLooks(), makeCpuDevice(plan.threads), settings.filePath("settings.ini"), plan.threads);
    desktop.bridge().setKeptMemory(0);
    desktop.window().show();
    if (!plan.window.isEmpty())
        desktop.window().resize(plan.window);
    desktop.open(plan.folder);
    if (!QTest::qWaitFor([&] { return desktop.bridge().lastFrame() && !desktop.bridge().lastFrame()->coarse; },
                         600'000)) {
        std::printf("no image of %s\n", qPrintable(plan.folder));
        return 1;
    }
    if (!plan.labels.isEmpty()) {
        auto& parts = desktop.presenter<PartsPresenter>();
        parts.open(plan.labels);
        if (!QTest::qWaitFor([&] { return !parts.job().isRunning(); }, 600'000) || !desktop.document().scanParts()) {
            std::printf("no parts in %s\n", qPrintable(plan.labels));
            return 1;
        }
    }
    const std::vector<NamedLook>& looks = desktop.document().looks().fitted();
    const auto look = std::ranges::find(looks, plan.look.toStdString(), &NamedLook::name);
    if (look == looks.end()) {
        std::printf("no look is called %s\n", qPrintable(plan.look));
        return 1;
    }
    desktop.document().chooseLook(int(look - looks.begin()));
    if (!plan.edit.isEmpty())
        return runEdit(desktop, plan);
    QTest::qWait(2000);
    const auto denoised = shownAfterView(desktop, plan.each);
    desktop.document().setDenoised(false);
    const auto raw = shownAfterView(desktop, plan.each);
    const Display display = desktop.document().display().withDenoised(true);
    const Scene scene = desktop.document().scene();
    desktop.bridge().setPaused(true);

    const auto film = referenceOf(scene, plan);
    if (!film)
        return 1;
    const Image best = imageOf(*film, display);
    const QImage truth = imageOf(best.rgba, scene.film);
    QString about = QString("reference: %1 samples, denoised").arg(plan.reference);
    if (const auto error = SmoothingJudgement::of(*film)->overAll(display))
        about += QString("\nwithin ±%1, at most ±%2").arg(error->levels, 0, 'f', 1).arg(error->levelsAtMost, 0, 'f', 1);
    std::printf("%s, %s: view of %d x %d pixels\n%s\n", qPrintable(plan.folder), qPrintable(plan.look), scene.film.x,
                scene.film.y, about.toUtf8().constData());
    std::vector<Trial> trials;
    for (const auto& [kind, shown] : {std::pair("raw", &raw), std::pair("denoised", &denoised)})
        for (std::size_t i = 0; i < kSeconds.size(); ++i)
            trials.push_back(trialOf(kind, kSeconds[i], (*shown)[i], truth, *film));
    const Trial reference{about, truth};
    if (!plan.out.isEmpty() && !sheetOf(trials, reference, tissueIn(*film)).save(plan.out, nullptr, 88))
        return 1;
    return 0;
}

}  // namespace
}  // namespace pdr::app

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    QCommandLineParser parser;
    parser.addPositionalArgument("FOLDER", "a folder with a CT");
    parser.addOption({"o", "draw all images on this sheet", "FILE"});
    parser.addOption({"look", "its name", "NAME", "Bone"});
    parser.addOption({"reference", "samples of the reference", "N", "256"});
    parser.addOption({"threads", "0: one per core", "N", "0"});
    parser.addOption({"edit", "edit the look: node:30, curve:20, opacity:0.9, albedo:0.9, lights:3 or cut:10", "EDIT"});
    parser.addOption({"film", "samples of the film before the edit", "N", "256"});
    parser.addOption({"window", "size of the window", "W,H"});
    parser.addOption({"labels", "a label map of the scan", "FILE"});
    parser.addOption({"json", "write the figures of an edit", "FILE"});
    parser.addOption({"each", "print when each image came"});
    parser.addHelpOption();
    parser.process(application);
    if (parser.positionalArguments().size() != 1)
        parser.showHelp(2);
    return pdr::app::run(
        {parser.positionalArguments()[0], parser.value("o"), parser.value("look"), parser.value("reference").toInt(),
         parser.value("threads").toInt(), parser.value("edit"), parser.value("json"), parser.value("film").toInt(),
         QSize(parser.value("window").section(',', 0, 0).toInt(), parser.value("window").section(',', 1).toInt()),
         parser.value("labels"), parser.isSet("each")});
}
