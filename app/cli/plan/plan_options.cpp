#include "app/cli/plan/plan_options.h"

#include "app/cli/parsed_options.h"
#include "app/cli/render/image_options.h"
#include "app/cli/scene/scene_options.h"
#include "app/command_line/option_reader.h"
#include "app/plan/marks_file.h"
#include "render/film/file/image_format.h"

namespace pdr::app {
namespace {

void describePlan(QCommandLineParser& parser) {
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    parser.addPositionalArgument("plan", "A plan that the window has saved.", "FILE");
    parser.addOptions({
        {{"h", "help"}, "Show this text."},
        {"scan",
         "The scan on which the plan was made: values are computed on it. Without it, values that depend on voxels are "
         "not known.",
         "FOLDER|SCENE.json"},
        {"series", "Take the series with this UID; default: the first that can be loaded.", "UID"},
        {"json", "Print the measurements as JSON."},
        {{"o", "output"},
         "Write the measurements as a table or as markups of 3D Slicer, or, with --render, an image; may be given "
         "several times.",
         "FILE.csv|.mrk.json|.png|.exr"},
        {"render", "Render what the plan shows of the scan; the options that follow are for that."},
        {"labels",
         "The label map whose parts the plan shows, as it was open in the window. Parts that the program has found are "
         "found again.",
         "FILE|FOLDER"},
        {"size", "Pixels; default 1024x1024.", "WxH"},
        {"threads", "Threads; default: one per core.", "N", "0"},
    });
    describeImageOptions(parser);
}

/// Sorts the outputs by what they hold.
void readPlanOutputs(const QCommandLineParser& parser, PlanOptions& options) {
    for (const QString& name : parser.values("output")) {
        const std::filesystem::path file = name.toStdString();
        if (isMarksFile(file))
            options.tables.push_back(file);
        else if (!imageFormat(file))
            usageError("-o", "must end in .csv, .mrk.json, .png or .exr, not be " + name.toStdString());
        else if (!options.image)
            usageError("-o", name.toStdString() + " is an image, which takes a while to render", "Add --render.");
        else
            options.image->outputs.push_back(file);
    }
    if (options.image && options.image->outputs.empty())
        usageError("--render", "needs a file for the image", "Add -o image.png.");
}

void readPlanCommand(const QCommandLineParser& parser, PlanOptions& options) {
    if (parser.positionalArguments().size() != 1)
        usageError("plan", "needs one plan file");
    const Reader reader(parser);
    options.file = parser.positionalArguments().front().toStdString();
    options.scan = reader.text("scan").value_or("").toStdString();
    options.seriesUid = reader.text("series").value_or("").toStdString();
    options.labels = reader.text("labels").value_or("").toStdString();
    options.json = parser.isSet("json");
    if (options.scan.empty() && (parser.isSet("render") || parser.isSet("series")))
        usageError("--scan", "says which scan the plan was made on, and is missing", "Add --scan FOLDER.");
    if (!options.labels.empty() && !parser.isSet("render"))
        usageError("--labels", "names what an image of the plan shows", "Add --render -o image.png.");
    if (parser.isSet("render")) {
        options.image.emplace();
        readImageOptions(parser, *options.image);
        options.image->scene.path = options.scan;
        options.image->scene.size = readSize(parser).value_or(ivec2(1024));
    }
    readPlanOutputs(parser, options);
}

}  // namespace

Result<PlanOptions> planOptions(const QStringList& arguments) {
    return parsed("plan", arguments, describePlan, readPlanCommand);
}

std::string planHelp() {
    return "Usage: pdrender-cli plan FILE [--scan FOLDER|SCENE.json] [--json] [-o FILE] [options]\n"
           "Lists what a plan has measured: each value with its ±, and its places in the patient. Values are "
           "computed\n"
           "again, on the scan that --scan names; another scan than the plan's is refused. A new file can be read by "
           "its\n"
           "owner only.\n" +
           optionsText(describePlan);
}

}  // namespace pdr::app
