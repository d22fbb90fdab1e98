#include "app/cli/prepared_work.h"

#include <utility>

#include "app/cli/failed.h"
#include "app/output/image_files.h"
#include "render/device/device_list.h"

namespace pdr::app {

Result<PreparedWork> prepareWork(const RenderOptions& options, const LoadWork& load, ProgressLine& line,
                                 const std::stop_token& stop) {
    if (auto ok = checkWritable(options.outputs); !ok)
        return ok.error();
    auto opened = openDeviceToTheEnd(options.device, options.threads, tellOfCpu, tellOfPreparation);
    if (!opened)
        return opened.error();
    std::unique_ptr<CommandNodes> crew;
    if (options.nodes.any()) {
        auto gathered = CommandNodes::gather(options.nodes, **opened);
        if (!gathered)
            return gathered.error();
        crew = *std::move(gathered);
    }
    auto loaded = load(line.until(stop));
    if (!loaded)
        return loaded.error();
    line.finish();
    tellNotes(*loaded);
    if (auto ok = checkSpared(loaded->files, options.outputs); !ok)
        return ok.error();
    std::unique_ptr<Device> device = *std::move(opened);
    if (crew)
        device = crew->share(std::move(device), loaded->scene, options.stops.samples);
    return PreparedWork{std::move(device), std::move(crew), *std::move(loaded)};
}

}  // namespace pdr::app
