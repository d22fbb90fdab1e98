#include "app/jobs/sky_job.h"

#include <utility>

#include "app/scan/environment_picture.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

void SkyJob::read(const QString& file) {
    start([this, file](const Progress& progress, const std::stop_token&) -> std::function<void()> {
        auto picture = readSky(ui::fromQt(file), progress);
        if (!picture)
            return failure(picture.error());
        return [this, picture = *std::move(picture)] { emit found(picture); };
    });
}

}  // namespace pdr::app
