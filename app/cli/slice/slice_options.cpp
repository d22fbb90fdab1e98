#include "app/cli/slice/slice_options.h"

#include "app/cli/parsed_options.h"
#include "app/cli/render/output_options.h"
#include "app/command_line/option_reader.h"

namespace pdr::app {
namespace {

std::string presetNames() {
    std::string names;
    for (const WindowPreset& preset : windowPresets())
        names += (names.empty() ? "" : ", ") + std::string(preset.name);
    return names;
}

void describeSlice(QCommandLineParser& parser) {
    parser.setOptionsAfterPositionalArgumentsMode(QCommandLineParser::ParseAsOptions);
    parser.addPositionalArgument("input", "A folder of DICOM files, or a scene file.", "FOLDER|SCENE.json");
    parser.addOptions({
        {{"h", "help"}, "Show this text."},
        {{"o", "output"}, "Write the slice here; may be given several times.", "FILE.png|FILE.exr"},
        {"plane", "axial, coronal or sagittal.", "PLANE"},
        {"index",
         "Number of the slice, from 0: from the feet (axial), the front (coronal) or the patient's right (sagittal). "
         "Default: the middle one.",
         "N"},
        {"at", "Instead of a number, the place: z (axial), y (coronal) or x (sagittal) in the patient (LPS).", "MM"},
        {"window",
         QString::fromStdString(
             "What is black and what is white in PNG files: centre and width in HU, such as 40/400; a name: " +
             presetNames() +
             "; file, as the files say; or whole, the range of the scan. Default: file, or else soft tissue."),
         "C/W|NAME"},
        {"series", "Take the series with this UID; default: the first that can be loaded.", "UID"},
        {"annotations",
         "What is written over PNG files: none; sides (default): the patient's sides, plane, window and scale; "
         "patient: that, and the patient's name, birth date and ID.",
         "none|sides|patient", "sides"},
    });
}

AnatomicalPlane readPlane(const Reader& reader) {
    const auto text = reader.text("plane");
    if (!text)
        usageError("--plane", "says which slice, and is missing", "Add --plane axial, coronal or sagittal.");
    for (const AnatomicalPlane plane : kAnatomicalPlanes)
        if (text->compare(QLatin1String(planeName(plane)), Qt::CaseInsensitive) == 0)
            return plane;
    usageError("--plane", "must be axial, coronal or sagittal, not \"" + text->toStdString() + "\"");
}

std::variant<ScanWindow, GreyWindow> readWindow(const Reader& reader, bool& isPreset) {
    const QString text = reader.text("window").value_or("");
    if (text.isEmpty() && !reader.text("window"))
        return ScanWindow::usual;
    const auto is = [&](const char* name) { return text.compare(QLatin1String(name), Qt::CaseInsensitive) == 0; };
    if (is("file"))
        return ScanWindow::file;
    if (is("whole"))
        return ScanWindow::whole;
    for (const WindowPreset& preset : windowPresets())
        if (is(preset.name)) {
            isPreset = true;
            return preset.window;
        }
    bool centreIs = false, widthIs = false;
    const GreyWindow window{text.section('/', 0, 0).toDouble(&centreIs), text.section('/', 1).toDouble(&widthIs)};
    if (centreIs && widthIs && window.valid())
        return window;
    usageError(
        "--window",
        "must be a centre and a width of at least 1 HU, such as 40/400, or a name, not \"" + text.toStdString() + "\"",
        "There are: " + presetNames() + ", file, whole.");
}

void readSlice(const QCommandLineParser& parser, SliceOptions& options) {
    if (parser.positionalArguments().size() != 1)
        usageError("slice", "needs one folder of DICOM files or one scene file");
    const Reader reader(parser);
    options.path = parser.positionalArguments().front().toStdString();
    options.seriesUid = reader.text("series").value_or("").toStdString();
    options.plane = readPlane(reader);
    options.index = reader.whole("index", 0, INT32_MAX);
    options.atMm = reader.number("at", {-1e6, 1e6});
    if (options.index && options.atMm)
        usageError("--at", "and --index both say where the slice lies", "Leave one of them out.");
    options.window = readWindow(reader, options.hasPreset);
    options.outputs = readOutputs(parser);
    options.annotate = readAnnotate(parser);
}

}  // namespace

Result<SliceOptions> sliceOptions(const QStringList& arguments) {
    return parsed("slice", arguments, describeSlice, readSlice);
}

std::string sliceHelp() {
    return "Usage: pdrender-cli slice FOLDER|SCENE.json --plane PLANE [--index N|--at MM] -o FILE [options]\n"
           "Writes a slice of the scan as it was read, with table and without a look: PNG through a window, OpenEXR "
           "with\n"
           "the HU as they are. Displayed as in radiology: axial from the feet, coronal from the front, sagittal from "
           "the\n"
           "left.\n" +
           optionsText(describeSlice);
}

}  // namespace pdr::app
