#include "app/cli/render/image_options.h"

#include <QRegularExpression>

#include "app/cli/nodes/node_options.h"
#include "app/cli/render/output_options.h"
#include "app/command_line/option_reader.h"

namespace pdr::app {

namespace {

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

}  // namespace

QCommandLineOption deviceOption() {
    return {"device", "What renders: auto (default; a GPU where there is one, else the CPU), cpu, cuda, cuda:1, ...",
            "NAME", "auto"};
}

void describeFinishOptions(QCommandLineParser& parser) {
    parser.addOptions({
        deviceOption(),
        {"denoised",
         "Take the noise out of PNG files, and fine detail that it hides; their error is written into them."},
        {"annotations",
         "What is written over PNG files: none; sides (default): the patient's sides, look, part, cut, scale, and what "
         "the image is worth; patient: that, and the patient's name, birth date and ID.",
         "none|sides|patient", "sides"},
    });
}

void describeImageOptions(QCommandLineParser& parser) {
    parser.addOptions({
        {"samples", "Stop after N samples per pixel; default 256 when no other stop is given.", "N"},
        {"seconds", "Stop after T seconds of rendering.", "T"},
        {"levels", "Stop when 95 % of the tissue is within L of 255 grey levels of the finished image, such as 8.",
         "L"},
        {"error",
         "Stop when the standard error of the tissue is E of its mean brightness, such as 0.05 or 5%; half of it takes "
         "four times as long.",
         "E"},
    });
    describeFinishOptions(parser);
    describeNodeOptions(parser);
}

int readThreads(const QCommandLineParser& parser) {
    return int(Reader(parser).whole("threads", 1, 1024).value_or(0));
}

std::string readDevice(const QCommandLineParser& parser) {
    const QString name = parser.value("device");
    if (!QRegularExpression("^(auto|cpu|cuda(:\\d{1,3})?)$").match(name).hasMatch())
        usageError("--device", "must be auto, cpu, cuda or a number after it such as cuda:1");
    return name.toStdString();
}

void readFinishOptions(const QCommandLineParser& parser, RenderOptions& options) {
    options.threads = readThreads(parser);
    options.denoised = parser.isSet("denoised");
    options.annotate = readAnnotate(parser);
    options.device = readDevice(parser);
}

void readImageOptions(const QCommandLineParser& parser, RenderOptions& options) {
    options.nodes = readNodeOptions(parser);
    options.stops = readStops(Reader(parser));
    readFinishOptions(parser, options);
}

}  // namespace pdr::app
