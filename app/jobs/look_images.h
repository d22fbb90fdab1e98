#pragma once
/// Renders small images of one volume under many looks, in parallel with the session on one CPU thread, from a coarser
/// copy of the volume: about 30 ms each.

#include <QImage>
#include <atomic>
#include <memory>
#include <utility>
#include <vector>

#include "app/jobs/background_job.h"
#include "render/scene/named_look.h"
#include "render/segment/body_parts.h"

namespace pdr::app {

struct LookTask {
    int look = 0;      ///< index of the look, repeated in made()
    ImageSetup setup;  ///< sets the camera's direction; the distance is chosen so that all of the body is visible
    std::shared_ptr<const LabelMap> parts;  ///< those of the scan, on its grid; null: there are none that it shows
    bool operator==(const LookTask&) const = default;
};

class LookImages : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Renders those of `tasks` whose images are not there yet in their order and emits made() for each, unless newer
    /// tasks replace them. The same tasks again, in any order, do nothing.
    /// The first images of a volume come as fast as possible, but all after the first one wait for the large image.
    /// Later ones begin after 600 ms without new tasks, and take a third of the time.
    /// `parts`: parts of the same scan. `body`: the part of its grid that fills the images.
    void make(const std::shared_ptr<const pdr::Volume>& volume,
              const std::shared_ptr<const pdr::segment::BodyParts>& parts, const pdr::VolumeGeometry& body,
              const std::vector<pdr::app::LookTask>& tasks);
    /// Cancels the running tasks and releases the volume.
    void forget();

    /// Sets whether there is a large image of the volume: until then the CPU is left to it. True before the first call.
    void setImageStands(bool stands) { *imageStands_ = stands; }

  signals:
    /// Reports an image. `stops`: the brightness at which it is shown, and which suits the look.
    void made(int look, const QImage& image, double stops);

  private:
    /// What is computed once for each volume and its parts.
    struct Coarse {
        std::shared_ptr<const Volume> volume;
        std::vector<std::pair<Visible, std::shared_ptr<const Mask>>> masks;
        std::weak_ptr<const LabelMap> fineParts;  ///< those of which `parts` were made
        std::shared_ptr<const LabelMap> parts;

        const std::shared_ptr<const Mask>& maskOf(const Visible& visible, const segment::BodyParts& parts,
                                                  const std::stop_token& stop);
        std::shared_ptr<const LabelMap> partsOf(const std::shared_ptr<const LabelMap>& fine);
    };

    void forgetImages();

    std::weak_ptr<const Volume> volume_;  ///< volume of the newest tasks
    std::vector<LookTask> tasks_;
    std::vector<LookTask> made_;  ///< those whose images are the newest of their looks
    Coarse coarse_;               ///< coarse copy, masks and parts of that volume, as far as they have been computed
    std::shared_ptr<std::atomic<bool>> imageStands_ = std::make_shared<std::atomic<bool>>(true);
};

}  // namespace pdr::app
