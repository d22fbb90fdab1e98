#include "app/cli/render_options.h"

#include <QRegularExpression>

#include "app/cli/option_reader.h"
#include "app/look_files.h"
#include "app/looks.h"

namespace pdr::app {
namespace {

/// Each view by its name, and as the window calls it.
struct ViewName {
    const char *name, *letter, *plain;
    StandardView view;
};
constexpr ViewName kViews[] = {
    {"anterior", "A", "front", StandardView::anterior}, {"posterior", "P", "back", StandardView::posterior},
    {"left", "L", "left", StandardView::left},          {"right", "R", "right", StandardView::right},
    {"superior", "H", "head", StandardView::superior},  {"inferior", "F", "feet", StandardView::inferior}};

/// The options of all commands that render.
void describeScene(QCommandLineParser& parser) {
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    parser.addPositionalArgument("input", "A folder of DICOM files, or a scene file.", "FOLDER|SCENE.json");
    parser.addOptions({
        {{"h", "help"}, "Show this text."},
        {"series", "Take the series with this UID; default: the first that can be loaded.", "UID"},
        {{"look", "preset"},
         "How it looks: a name that `pdrender-cli looks` lists, or a file of a look: .json, or "
         "Slicer's .vp.json and .vp. Default: of a folder the "
         "first look that makes sense of it.",
         "NAME"},
        {"view",
         "Look from anterior (default, but of few slices the side that they face), posterior, left, right, superior or "
         "inferior; A, P, L, R, H, F for short.",
         "SIDE"},
        {"table",
         "hidden or shown: the scanner's table, head holder, clothes. Default: hidden, or what the scene file says.",
         "WORD"},
        {"show",
         "The part of the patient: everything, lungs, bones or withoutBones. Default: what the look or the scene file "
         "says.",
         "PART"},
        {"peel", "Take so much off all around the body, such as skin; up to 50.", "MM"},
        {"size", "Pixels; default 1024x1024, or what the scene file says.", "WxH"},
        {"exposure",
         "Radiance that PNG shows as 63 % of white, or auto: so that the tissue is neither dark nor blown out; "
         "default: "
         "the look's, or 1.",
         "L"},
        {"model",
         "Optical model: absorption, emission, emissionAbsorption, singleScattering, multipleScattering or "
         "maximumIntensity.",
         "NAME"},
        {"estimator",
         "How scattering is computed: unbiased (default), or kroesMarch, as Exposure Render does: BIASED, for "
         "comparison.",
         "NAME"},
        {"aperture", "Diameter of the lens in mm; 0: everything is sharp.", "MM"},
        {"focus", "Make sharp what this pixel shows.", "X,Y"},
        {"threads", "Threads; default: one per core.", "N", "0"},
        {"seed", "Seed of the random numbers; default 1, or what the scene file says.", "N"},
    });
}

const QCommandLineOption kDeviceOption(
    "device", "What renders: auto (default; a GPU where there is one, else the CPU), cpu, cuda, cuda:1, ...", "NAME",
    "auto");

void describeRender(QCommandLineParser& parser) {
    describeScene(parser);
    parser.addOptions({
        {{"o", "output"}, "Write the picture here; may be given several times.", "FILE.png|FILE.exr"},
        {"samples", "Stop after N samples per pixel; default 256 when no other stop is given.", "N"},
        {"seconds", "Stop after T seconds of rendering.", "T"},
        {"levels", "Stop when 95 % of the tissue is within L of 255 grey levels of the finished picture, such as 8.",
         "L"},
        {"error",
         "Stop when the standard error of the tissue is E of its mean brightness, such as 0.05 or 5%; half of it takes "
         "four times as long.",
         "E"},
        kDeviceOption,
        {"smoothed",
         "Take the noise out of PNG files, and fine detail that it hides; their error is written into them."},
        {"json", "Print samples, seconds, samples per second and error as JSON."},
        {"node", "Let the render node at this address help; may be given several times.", "HOST[:PORT]"},
        {"listen", "Let render nodes help that dial this machine.", "[HOST:]PORT"},
        {"bundle",
         "The folder of certificates for connections to other machines (pdrender-node --make-certificates); without it "
         "nodes must be on this one.",
         "DIR"},
        {"await", "Begin when N nodes are ready; default: at once, and nodes join as they come.", "N"},
        {"nodes-only", "This machine only checks what nodes send, as long as there is one."},
        {"split",
         "How the picture is shared out: tiles (each a part of it) or samples (each all of it, in blocks of 64 "
         "samples). Default: what a model of their costs finds faster.",
         "WORD"},
    });
}

void describeEffects(QCommandLineParser& parser) {
    describeScene(parser);
    parser.addOption({"json", "Print the same as JSON."});
}

void describeAccuracy(QCommandLineParser& parser) {
    describeScene(parser);
    parser.addOptions({
        {{"o", "output"}, "Write accuracy.html, .svg, .csv, .json and the pictures into this folder.", "DIR"},
        {"time-limit", "Render for T seconds in all; default 120.", "T", "120"},
        kDeviceOption,
    });
}

void describeReplay(QCommandLineParser& parser) {
    describeScene(parser);
    parser.addOptions({
        {"pixel", "The pixel, from the upper left corner.", "X,Y"},
        {"sample", "Which of its samples, from 0.", "N", "0"},
    });
}

std::optional<ivec2> readSize(const Reader& reader) {
    const auto text = reader.text("size");
    if (!text)
        return std::nullopt;
    const auto match = QRegularExpression("^(\\d{1,5})x(\\d{1,5})$").match(*text);
    const ivec2 size(match.captured(1).toInt(), match.captured(2).toInt());
    const Range range{1, 16384};
    if (!match.hasMatch() || !range.holds(size.x) || !range.holds(size.y))
        usageError("--size", "must look like 800x600, each number " + range.text());
    return size;
}

std::optional<ivec2> readPixel(const Reader& reader, const QString& name) {
    const auto text = reader.text(name);
    if (!text)
        return std::nullopt;
    const auto match = QRegularExpression("^(\\d{1,5}),(\\d{1,5})$").match(*text);
    if (!match.hasMatch())
        usageError("--" + name, "must look like 400,300");
    return ivec2(match.captured(1).toInt(), match.captured(2).toInt());
}

std::optional<Model> readModel(const Reader& reader) {
    const auto text = reader.text("model");
    if (!text)
        return std::nullopt;
    std::string known;
    for (const Model model : kModels) {
        if (text->compare(QLatin1String(modelName(model)), Qt::CaseInsensitive) == 0)
            return model;
        known += (known.empty() ? "" : ", ") + std::string(modelName(model));
    }
    usageError("--model", "must be one of: " + known);
}

std::optional<Estimator> readEstimator(const Reader& reader) {
    const auto text = reader.text("estimator");
    if (!text)
        return std::nullopt;
    for (const Estimator estimator : kEstimators)
        if (text->compare(QLatin1String(estimatorName(estimator)), Qt::CaseInsensitive) == 0)
            return estimator;
    usageError("--estimator", "must be unbiased or kroesMarch");
}

std::optional<Table> readTable(const Reader& reader) {
    const auto text = reader.text("table");
    if (!text)
        return std::nullopt;
    if (*text != "hidden" && *text != "shown")
        usageError("--table", "must be hidden or shown");
    return *text == "hidden" ? Table::hidden : Table::shown;
}

std::optional<BodyPart> readPart(const Reader& reader) {
    const auto text = reader.text("show");
    if (!text)
        return std::nullopt;
    for (const BodyPart part : kBodyParts)
        if (text->compare(QLatin1String(bodyPartName(part)), Qt::CaseInsensitive) == 0)
            return part;
    usageError("--show", "must be everything, lungs, bones or withoutBones");
}

std::optional<StandardView> readView(const Reader& reader) {
    const auto text = reader.text("view");
    if (!text)
        return std::nullopt;
    std::string known;
    for (const ViewName& one : kViews) {
        for (const char* name : {one.name, one.letter, one.plain})
            if (text->compare(QLatin1String(name), Qt::CaseInsensitive) == 0)
                return one.view;
        known += (known.empty() ? "" : ", ") + std::string(one.name) + " (" + one.letter + ")";
    }
    usageError("--view", "must be one of: " + known);
}

std::optional<NamedLook> readLook(const Reader& reader) {
    const auto text = reader.text("look");
    if (!text)
        return std::nullopt;
    if (text->endsWith(".json") || text->endsWith(".vp")) {
        const auto bundled = bundledLooks();
        if (!bundled)
            throw bundled.error();
        const auto look = readLookFile(*text, bundled->front());
        if (!look)
            throw look.error();
        return *look;
    }
    const auto looks = bundledLooks();
    if (!looks)
        throw looks.error();
    std::string known;
    for (const NamedLook& look : *looks) {
        if (QString::fromStdString(look.name).compare(*text, Qt::CaseInsensitive) == 0)
            return look;
        known += (known.empty() ? "" : ", ") + look.name;
    }
    usageError("--look", "there is no look \"" + text->toStdString() + "\"", "There are: " + known + ".");
}

std::vector<std::filesystem::path> readOutputs(const QCommandLineParser& parser) {
    std::vector<std::filesystem::path> outputs;
    for (const QString& name : parser.values("output")) {
        outputs.emplace_back(name.toStdString());
        const auto extension = outputs.back().extension();
        if (extension != ".png" && extension != ".exr")
            usageError("-o", "must end in .png or .exr, not be " + name.toStdString());
    }
    if (outputs.empty())
        usageError("-o", "says where the picture goes, and is missing", "Add -o picture.png.");
    return outputs;
}

Stops readStops(const Reader& reader) {
    Stops stops;
    stops.samples = reader.whole("samples", 1, 1'000'000'000);
    stops.seconds = reader.number("seconds", {0, 1e9, false});
    stops.relativeError = reader.fraction("error", {0, 1, false});
    stops.levels = reader.number("levels", {0, 255, false});
    if (!stops.samples && !stops.seconds && !stops.relativeError && !stops.levels)
        stops.samples = 256;
    return stops;
}

SceneInput readScene(const QCommandLineParser& parser, const QString& command) {
    if (parser.positionalArguments().size() != 1)
        usageError(command, "needs one folder of DICOM files or one scene file");
    const Reader reader(parser);
    SceneInput scene;
    scene.path = parser.positionalArguments().front().toStdString();
    scene.seriesUid = reader.text("series").value_or("").toStdString();
    scene.size = readSize(reader);
    scene.view = readView(reader);
    scene.table = readTable(reader);
    scene.part = readPart(reader);
    scene.peelMm = reader.number("peel", {0, 50});
    scene.autoExposure = reader.text("exposure") == "auto";
    if (!scene.autoExposure)
        scene.exposure = reader.number("exposure", {0, 1e30, false});
    scene.seed = reader.whole("seed", 0, UINT64_MAX);
    scene.look = readLook(reader);
    scene.model = readModel(reader);
    scene.estimator = readEstimator(reader);
    scene.apertureMm = reader.number("aperture", {0, 200});
    scene.focusAt = readPixel(reader, "focus");
    return scene;
}

int readThreads(const QCommandLineParser& parser) {
    return int(Reader(parser).whole("threads", 1, 1024).value_or(0));
}

/// Whether it is there is found out when it is opened.
std::string readDevice(const QCommandLineParser& parser) {
    const QString name = parser.value("device");
    if (!QRegularExpression("^(auto|cpu|cuda(:\\d{1,3})?)$").match(name).hasMatch())
        usageError("--device", "must be auto, cpu, cuda or a number after it such as cuda:1");
    return name.toStdString();
}

NodesWanted readNodes(const QCommandLineParser& parser) {
    const Reader reader(parser);
    NodesWanted nodes;
    nodes.nodes = parser.values("node");
    nodes.listen = reader.text("listen");
    nodes.bundle = reader.text("bundle").value_or("");
    nodes.await = int(reader.whole("await", 0, 100000).value_or(0));
    nodes.nodesOnly = parser.isSet("nodes-only");
    if (const auto split = reader.text("split")) {
        if (*split != "tiles" && *split != "samples")
            usageError("--split", "must be tiles or samples");
        nodes.split = *split == "tiles" ? Split::tiles : Split::samples;
    }
    for (const char* option : {"bundle", "await", "nodes-only", "split"})
        if (parser.isSet(option) && !nodes.any())
            usageError(QString("--") + option, "is for render nodes, and none are named", "Add --node or --listen.");
    return nodes;
}

void readRender(const QCommandLineParser& parser, RenderOptions& options) {
    options.nodes = readNodes(parser);
    options.scene = readScene(parser, "render");
    options.outputs = readOutputs(parser);
    options.stops = readStops(Reader(parser));
    options.threads = readThreads(parser);
    options.smoothed = parser.isSet("smoothed");
    options.json = parser.isSet("json");
    options.device = readDevice(parser);
}

void readEffects(const QCommandLineParser& parser, EffectsOptions& options) {
    options.scene = readScene(parser, "effects");
    options.threads = readThreads(parser);
    options.json = parser.isSet("json");
}

void readAccuracy(const QCommandLineParser& parser, AccuracyOptions& options) {
    options.scene = readScene(parser, "accuracy");
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
    options.scene = readScene(parser, "replay");
    const auto pixel = readPixel(Reader(parser), "pixel");
    if (!pixel)
        usageError("--pixel", "says which pixel, and is missing", "Add --pixel 400,300.");
    options.pixel = *pixel;
    options.sample = Reader(parser).whole("sample", 0, UINT64_MAX).value_or(0);
}

/// Parses `arguments` of `command` as `describe` says and hands them to `read`, unless they only ask for help.
template <class Options>
Result<Options> parsed(const QString& command, const QStringList& arguments, void (*describe)(QCommandLineParser&),
                       void (*read)(const QCommandLineParser&, Options&)) {
    QCommandLineParser parser;
    describe(parser);
    if (!parser.parse(QStringList(command) + arguments))
        return Error{parser.errorText().toStdString(), command.toStdString(), ""};
    Options options;
    options.help = parser.isSet("help");
    try {
        if (!options.help)
            read(parser, options);
    } catch (const Error& error) {
        return error;
    }
    return options;
}

std::string optionsText(void (*describe)(QCommandLineParser&)) {
    QCommandLineParser parser;
    describe(parser);
    QString text = parser.helpText();
    text.remove(0, text.indexOf('\n') + 1);  // the parser's usage line knows nothing of the command's word
    return text.toStdString();
}

}  // namespace

Result<RenderOptions> renderOptions(const QStringList& arguments) {
    return parsed("render", arguments, describeRender, readRender);
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
           "Renders a picture. It ends at the first stop that is reached. Ctrl-C ends it early, and so does the end of "
           "the\n"
           "terminal's session: what is there is then written and the exit code is 1; a second Ctrl-C ends at once "
           "and\n"
           "writes nothing. A new picture can be read by its owner only; one that is replaced keeps its "
           "permissions.\n" +
           optionsText(describeRender);
}

std::string accuracyHelp() {
    return "Usage: pdrender-cli accuracy FOLDER|SCENE.json -o DIR [--time-limit T] [options]\n"
           "Measures what accuracy costs in time: the picture as it is, smoothed, and in every way that Exposure "
           "Render\n"
           "or a fast filter would make it, each against a picture of more samples with other random numbers, which\n"
           "takes most of the time; then the other models, and slices interpolated, against theirs. 512x512 pixels\n"
           "unless --size says otherwise. Ctrl-C ends it with what was measured until then; the exit code is 1. Run "
           "again with\n"
           "the same folder, also with a longer time limit, it goes on from the reference that it left there.\n" +
           optionsText(describeAccuracy);
}

std::string effectsHelp() {
    return "Usage: pdrender-cli effects FOLDER|SCENE.json [options]\n"
           "Lists every effect: whether the picture needs it and why, what it costs (milliseconds of processor time\n"
           "per iteration of a small picture, and its share), by how many display levels the picture changes without\n"
           "it (mean, and what 95 % of it stay below), and how long any target takes without it, in percent of the\n"
           "time with it; without shadows: light reaches all tissue unhindered. Then what each model would cost.\n"
           "--json: meanLevels, levels95 and timeWithout with their 95 % interval (low, high), milliseconds and\n"
           "share with the smallest and the largest of six measurements.\n"
           "Takes about 10 s of processor time.\n" +
           optionsText(describeEffects);
}

}  // namespace pdr::app
