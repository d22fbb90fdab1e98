#include "app/cli/render/render_command.h"

#include <cstdio>

#include "app/cli/batch/share_run.h"
#include "app/cli/render/image_run.h"
#include "app/cli/run_command.h"

namespace pdr::app {

int runRender(const QStringList& arguments) {
    const Interrupt interrupt;
    return runCommand("render", renderOptions(arguments), renderHelp, [&](const RenderOptions& options) {
        const auto load = [&](const Progress& progress) { return loadScene(options.scene, progress); };
        if (options.share)
            return renderShare(options, load, interrupt);
        const auto say = [&](const RenderReport& report) {
            std::fputs((options.json ? jsonText(report) : plainText(report)).c_str(), stdout);
        };
        return renderImages(options, {load, say}, interrupt);
    });
}

}  // namespace pdr::app
