#include "app/jobs/sky_job.h"

#include <utility>

#include "app/scan/environment_image.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

void SkyJob::read(const QString& file) {
    start([this, file](const Progress& progress, const std::stop_token&) -> std::function<void()> {
        auto image = readSky(ui::fromQt(file), progress);
        if (!image)
            return failure(image.error());
        return [this, image = *std::move(image)] { emit found(image); };
    });
}

}  // namespace pdr::app
