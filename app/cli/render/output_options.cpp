#include "app/cli/render/output_options.h"

#include "app/command_line/option_reader.h"
#include "render/film/file/image_format.h"

namespace pdr::app {

std::vector<std::filesystem::path> readOutputs(const QCommandLineParser& parser) {
    std::vector<std::filesystem::path> outputs;
    for (const QString& name : parser.values("output")) {
        outputs.emplace_back(name.toStdString());
        if (!imageFormat(outputs.back()))
            usageError("-o", "must end in .png or .exr, not be " + name.toStdString());
    }
    if (outputs.empty())
        usageError("-o", "says where the image goes, and is missing", "Add -o image.png.");
    return outputs;
}

ui::Annotate readAnnotate(const QCommandLineParser& parser) {
    const QString word = parser.value("annotations");
    if (word == "none")
        return ui::Annotate::none;
    if (word == "patient")
        return ui::Annotate::patient;
    if (word != "sides")
        usageError("--annotations", "must be none, sides or patient");
    return ui::Annotate::sides;
}

}  // namespace pdr::app
