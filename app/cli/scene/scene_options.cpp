#include "app/cli/scene/scene_options.h"

#include <QRegularExpression>
#include <algorithm>

#include "app/cli/scene/look_option.h"
#include "app/command_line/option_reader.h"
#include "render/base/image_size.h"

namespace pdr::app {
namespace {

/// Names of a view: its own, and the letter and the plain word of the window.
struct ViewName {
    const char *name, *letter, *plain;
    StandardView view;
};
constexpr ViewName kViews[] = {
    {"anterior", "A", "front", StandardView::anterior}, {"posterior", "P", "back", StandardView::posterior},
    {"left", "L", "left", StandardView::left},          {"right", "R", "right", StandardView::right},
    {"superior", "H", "head", StandardView::superior},  {"inferior", "F", "feet", StandardView::inferior}};

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

std::optional<ToneCurve> readToneCurve(const Reader& reader) {
    const auto text = reader.text("tone-curve");
    if (!text)
        return std::nullopt;
    for (const ToneCurve curve : {ToneCurve::keepsHue, ToneCurve::perChannel})
        if (*text == toneCurveName(curve))
            return curve;
    usageError("--tone-curve", "must be keepsHue or perChannel");
}

std::optional<Table> readTable(const Reader& reader) {
    const auto text = reader.text("table");
    if (!text)
        return std::nullopt;
    if (*text != "hidden" && *text != "shown")
        usageError("--table", "must be hidden or shown");
    return *text == "hidden" ? Table::hidden : Table::shown;
}

segment::Labels readLabels(const Reader& reader, const char* option, const QString& none) {
    const QString text = reader.text(option).value_or(none).toLower();
    segment::Labels labels;
    for (const QString& label : text == none ? QStringList() : text.split(','))
        labels.insert(label.trimmed().toStdString());
    for (const std::string& label : labels)
        if (std::ranges::find(segment::kFoundLabels, label) == std::end(segment::kFoundLabels))
            usageError(QString("--") + option,
                       "must be " + none.toStdString() + ", bones, lungs, or both with a comma in between");
    return labels;
}

/// Reads the shown and hidden parts; none: neither option is given.
std::optional<Visible> readParts(const Reader& reader) {
    if (!reader.text("show") && !reader.text("hide"))
        return std::nullopt;
    return Visible{readLabels(reader, "show", "everything"), readLabels(reader, "hide", "nothing")};
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
    return namedLook(*text, "--look");
}

}  // namespace

void describeSceneOptions(QCommandLineParser& parser) {
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    parser.addPositionalArgument("input", "A folder of DICOM files, a ZIP archive or volume file, or a scene file.",
                                 "FOLDER|SCENE.json");
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
         "The parts of the patient that alone are shown: bones, lungs, \"bones,lungs\", or everything. Default: what "
         "the look or the scene file says, unless --hide is given.",
         "PARTS"},
        {"hide", "The parts that are left out: bones, lungs, \"bones,lungs\", or nothing. Default: as for --show.",
         "PARTS"},
        {"peel", "Take so much off all around the body, such as skin; up to 50.", "MM"},
        {"ct-denoised",
         "Take noise off the CT for this image, within each slice. Images and files say so; the scan itself stays."},
        {"size", "Pixels; default 1024x1024, or what the scene file says.", "WxH"},
        {"exposure",
         "Radiance that PNG shows as 63 % of white, or auto: so that the tissue is neither dark nor blown out; "
         "default: "
         "the look's, or 1.",
         "L"},
        {"tone-curve",
         "How the channels of a colour become levels: keepsHue or perChannel; default: the look's, or perChannel.",
         "NAME"},
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
    describePartLooks(parser);
}

std::optional<ivec2> readSize(const QCommandLineParser& parser) {
    const auto text = Reader(parser).text("size");
    if (!text)
        return std::nullopt;
    const auto match = QRegularExpression("^(\\d{1,5})x(\\d{1,5})$").match(*text);
    const ivec2 size(match.captured(1).toInt(), match.captured(2).toInt());
    const Range range{1, kLongestSide};
    if (!match.hasMatch() || !range.holds(size.x) || !range.holds(size.y))
        usageError("--size", "must look like 800x600, each number " + range.text());
    return size;
}

std::optional<ivec2> readPixel(const QCommandLineParser& parser, const QString& name) {
    const auto text = Reader(parser).text(name);
    if (!text)
        return std::nullopt;
    const auto match = QRegularExpression("^(\\d{1,5}),(\\d{1,5})$").match(*text);
    if (!match.hasMatch())
        usageError("--" + name, "must look like 400,300");
    return ivec2(match.captured(1).toInt(), match.captured(2).toInt());
}

SceneInput readSceneOptions(const QCommandLineParser& parser, const QString& command) {
    if (parser.positionalArguments().size() != 1)
        usageError(command, "needs one folder of DICOM files or one scene file");
    return readOptionsOfScene(parser, parser.positionalArguments().front().toStdString());
}

SceneInput readOptionsOfScene(const QCommandLineParser& parser, const std::filesystem::path& path) {
    const Reader reader(parser);
    SceneInput scene;
    scene.path = path;
    scene.seriesUid = reader.text("series").value_or("").toStdString();
    scene.size = readSize(parser);
    scene.view = readView(reader);
    scene.table = readTable(reader);
    scene.parts = readParts(reader);
    scene.peelMm = reader.number("peel", {0, 50});
    scene.ctDenoised = parser.isSet("ct-denoised");
    scene.autoExposure = reader.text("exposure") == "auto";
    if (!scene.autoExposure)
        scene.exposure = reader.number("exposure", {0, 1e30, false});
    scene.toneCurve = readToneCurve(reader);
    scene.seed = reader.whole("seed", 0, UINT64_MAX);
    scene.look = readLook(reader);
    scene.partLooks = readPartLooks(parser);
    scene.model = readModel(reader);
    scene.estimator = readEstimator(reader);
    scene.apertureMm = reader.number("aperture", {0, 200});
    scene.focusAt = readPixel(parser, "focus");
    return scene;
}

}  // namespace pdr::app
