#include "app/cli/render/render_options.h"

#include "app/cli/parsed_options.h"
#include "app/cli/render/image_options.h"
#include "app/cli/render/output_options.h"
#include "app/cli/scene/scene_options.h"
#include "app/command_line/option_reader.h"

namespace pdr::app {
namespace {

void describeRender(QCommandLineParser& parser) {
    describeSceneOptions(parser);
    parser.addOptions({
        {{"o", "output"}, "Write the image here; may be given several times.", "FILE.png|FILE.exr"},
        {"json", "Print samples, seconds, samples per second and error as JSON."},
        {"share",
         "Render the Kth of N shares of the image alone, and write its film to -o FILE.film; \"pdrender-cli merge\" "
         "makes the image of all of them.",
         "K/N"},
    });
    describeImageOptions(parser);
}

void describeMerge(QCommandLineParser& parser) {
    describeSceneOptions(parser);
    parser.addOptions({
        {{"o", "output"},
         "Write the image, or all films as one, here; an image may be written to several files.",
         "FILE.png|.exr|.film"},
        {"json", "Print samples, seconds, samples per second and error as JSON."},
    });
    describeFinishOptions(parser);
}

void describeEffects(QCommandLineParser& parser) {
    describeSceneOptions(parser);
    parser.addOption({"json", "Print the same as JSON."});
}

void describeAccuracy(QCommandLineParser& parser) {
    describeSceneOptions(parser);
    parser.addOptions({
        {{"o", "output"}, "Write accuracy.html, .svg, .csv, .json and the images into this folder.", "DIR"},
        {"time-limit", "Render for T seconds in all; default 120.", "T", "120"},
        deviceOption(),
    });
}

void describeReplay(QCommandLineParser& parser) {
    describeSceneOptions(parser);
    parser.addOptions({
        {"pixel", "The pixel, from the upper left corner.", "X,Y"},
        {"sample", "Which of its samples, from 0.", "N", "0"},
    });
}

/// Reads `--share` and what goes with it.
void readShareOptions(const QCommandLineParser& parser, RenderOptions& options) {
    const auto share = readShare(parser.value("share").toStdString());
    if (!share)
        throw share.error();
    options.share = *share;
    for (const char* option : {"seconds", "levels", "error", "denoised", "json", "node", "listen"})
        if (parser.isSet(option))
            usageError(QString("--") + option, "does not go with --share: all shares have the same samples",
                       "Give --samples alone, and the rest to \"pdrender-cli merge\".");
    const QStringList outputs = parser.values("output");
    if (outputs.size() != 1 || !outputs.front().endsWith(".film"))
        usageError("-o", "must name one file that ends in .film for a share", "Add -o share.film.");
    options.outputs = {outputs.front().toStdString()};
}

void readRender(const QCommandLineParser& parser, RenderOptions& options) {
    options.scene = readSceneOptions(parser, "render");
    if (parser.isSet("share"))
        readShareOptions(parser, options);
    else
        options.outputs = readOutputs(parser);
    readImageOptions(parser, options);
    options.json = parser.isSet("json");
}

void readMerge(const QCommandLineParser& parser, MergeOptions& options) {
    const QStringList outputs = parser.values("output"), inputs = parser.positionalArguments();
    const bool joins = outputs.size() == 1 && outputs.front().endsWith(".film");
    if (joins)
        options.film = outputs.front().toStdString();
    else
        options.render.outputs = readOutputs(parser);
    for (const QString& input : inputs.mid(joins ? 0 : 1))
        options.films.emplace_back(input.toStdString());
    if (!joins && !inputs.isEmpty() && inputs.front().endsWith(".film"))
        usageError("merge", "needs the scan before the films, to make an image of them",
                   "Name the folder or scene file, with the options of the rendering.");
    if (options.films.empty())
        usageError("merge", "needs films", "Name files that \"pdrender-cli render --share\" has written.");
    if (!joins)
        options.render.scene = readOptionsOfScene(parser, inputs.front().toStdString());
    readFinishOptions(parser, options.render);
    options.render.json = parser.isSet("json");
}

void readEffects(const QCommandLineParser& parser, EffectsOptions& options) {
    options.scene = readSceneOptions(parser, "effects");
    options.threads = readThreads(parser);
    options.json = parser.isSet("json");
}

void readAccuracy(const QCommandLineParser& parser, AccuracyOptions& options) {
    options.scene = readSceneOptions(parser, "accuracy");
    if (!parser.isSet("output"))
        usageError("-o", "says where the report goes, and is missing", "Add -o report.");
    options.folder = parser.value("output").toStdString();
    options.seconds = Reader(parser).number("time-limit", {0, 1e9, false}).value_or(120);
    options.device = readDevice(parser);
    options.threads = readThreads(parser);
    if (!options.scene.size)
        options.scene.size = ivec2(512);
}

void readReplay(const QCommandLineParser& parser, ReplayOptions& options) {
    options.scene = readSceneOptions(parser, "replay");
    const auto pixel = readPixel(parser, "pixel");
    if (!pixel)
        usageError("--pixel", "says which pixel, and is missing", "Add --pixel 400,300.");
    options.pixel = *pixel;
    options.sample = Reader(parser).whole("sample", 0, UINT64_MAX).value_or(0);
}

}  // namespace

Result<RenderOptions> renderOptions(const QStringList& arguments) {
    return parsed("render", arguments, describeRender, readRender);
}

Result<MergeOptions> mergeOptions(const QStringList& arguments) {
    return parsed("merge", arguments, describeMerge, readMerge);
}

Result<EffectsOptions> effectsOptions(const QStringList& arguments) {
    return parsed("effects", arguments, describeEffects, readEffects);
}

Result<AccuracyOptions> accuracyOptions(const QStringList& arguments) {
    return parsed("accuracy", arguments, describeAccuracy, readAccuracy);
}

Result<ReplayOptions> replayOptions(const QStringList& arguments) {
    return parsed("replay", arguments, describeReplay, readReplay);
}

std::string replayHelp() {
    return "Usage: pdrender-cli replay FOLDER|SCENE.json --pixel X,Y [--sample N] [options]\n"
           "Traces one sample of one pixel again and tells its path event by event. With the options of a rendering "
           "it\n"
           "is that rendering's sample, bit by bit.\n" +
           optionsText(describeReplay);
}

std::string renderHelp() {
    return "Usage: pdrender-cli render FOLDER|SCENE.json -o FILE [options]\n"
           "Renders an image. It ends at the first stop that is reached. Ctrl-C ends it early, and so does the end of "
           "the\n"
           "terminal's session: what is there is then written and the exit code is 1; a second Ctrl-C ends at once "
           "and\n"
           "writes nothing. A new image can be read by its owner only; one that is replaced keeps its "
           "permissions.\n" +
           optionsText(describeRender);
}

std::string mergeHelp() {
    return "Usage: pdrender-cli merge FOLDER|SCENE.json FILM... -o FILE [options]\n"
           "       pdrender-cli merge FILM... -o ALL.film\n"
           "Makes an image of the films that \"pdrender-cli render --share\" has written, in any order: the same, bit "
           "by "
           "bit,\n"
           "as if one machine had rendered all of it. The options are those of the rendering; exposure, tone, "
           "denoising "
           "and\n"
           "annotations may be others. To -o ALL.film: puts films together, for another merge, and needs no scan.\n" +
           optionsText(describeMerge);
}

std::string accuracyHelp() {
    return "Usage: pdrender-cli accuracy FOLDER|SCENE.json -o DIR [--time-limit T] [options]\n"
           "Measures what accuracy costs in time: the image as it is, denoised, and in every way that Exposure "
           "Render\n"
           "or a fast filter would make it, each against an image of more samples with other random numbers, which\n"
           "takes most of the time; then the other models, and slices interpolated, against theirs. 512x512 pixels\n"
           "unless --size says otherwise. Ctrl-C ends it with what was measured until then; the exit code is 1. Run "
           "again with\n"
           "the same folder, also with a longer time limit, it goes on from the reference that it left there.\n" +
           optionsText(describeAccuracy);
}

std::string effectsHelp() {
    return "Usage: pdrender-cli effects FOLDER|SCENE.json [options]\n"
           "Lists every effect: whether the image needs it and why, what it costs (milliseconds of processor time\n"
           "per iteration of a small image, and its share), by how many display levels the image changes without\n"
           "it (mean, and what 95 % of it stay below), and how long any target takes without it, in percent of the\n"
           "time with it; without shadows: light reaches all tissue unhindered. Then what each model would cost.\n"
           "--json: meanLevels, levels95 and timeWithout with their 95 % interval (low, high), milliseconds and\n"
           "share with the smallest and the largest of six measurements.\n"
           "Takes about 10 s of processor time.\n" +
           optionsText(describeEffects);
}

}  // namespace pdr::app
