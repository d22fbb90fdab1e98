#include "app/cli/parts/parts_options.h"

#include "app/cli/parsed_options.h"
#include "app/command_line/option_reader.h"
#include "render/volume/file/label_nrrd.h"

namespace pdr::app {
namespace {

void describeParts(QCommandLineParser& parser) {
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    parser.addPositionalArgument("scan", "The scan.", "FOLDER|SCENE.json");
    describePartsSource(parser);
    parser.addOptions({
        {{"h", "help"}, "Show this text."},
        {"series", "Take the series with this UID; default: the first that can be loaded.", "UID"},
        {"json", "Print the list as JSON."},
        {{"o", "output"}, "Write the parts on the scan's grid, for 3D Slicer and others.", "FILE.seg.nrrd"},
    });
}

void readParts(const QCommandLineParser& parser, PartsOptions& options) {
    if (parser.positionalArguments().size() != 1)
        usageError("parts", "needs one scan");
    const Reader reader(parser);
    options.scan = parser.positionalArguments().front().toStdString();
    options.seriesUid = reader.text("series").value_or("").toStdString();
    options.output = reader.text("output").value_or("").toStdString();
    options.json = parser.isSet("json");
    options.source = readPartsSource(parser);
    if (!options.source.isGiven())
        usageError("parts", "needs --labels or --find, which say where the parts come from");
    if (!options.output.empty() && !isLabelFile(options.output))
        usageError("--output", std::string("must end in ") + kLabelEnding);
}

}  // namespace

Result<PartsOptions> partsOptions(const QStringList& arguments) {
    return parsed("parts", arguments, describeParts, readParts);
}

std::string partsHelp() {
    return "Usage: pdrender-cli parts FOLDER|SCENE.json --labels FILE|FOLDER|--find PARTS [-o FILE.seg.nrrd] "
           "[options]\n"
           "Lists the parts of the patient that a label map marks in a scan, or that the program finds there, with "
           "their "
           "volumes\nby whole voxels. A map whose voxels are not those of the scan is refused, with the reason, or "
           "resampled if that is\nasked for. A new file can be read by its owner only.\n" +
           optionsText(describeParts);
}

}  // namespace pdr::app
