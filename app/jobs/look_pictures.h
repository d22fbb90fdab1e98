#pragma once
/// Small pictures of one volume under many looks, made beside the session on one thread of the processor, of a coarser
/// copy of the volume: some 30 ms each.

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
    int look = 0;        ///< what the answer is of
    PictureSetup setup;  ///< with the camera's direction; the distance is so that all of the body is seen
    bool operator==(const LookTask&) const = default;
};

class LookPictures : public BackgroundJob {
    Q_OBJECT

  public slots:
    /// Ends with a made() for each of the tasks, in their order, unless others come first. The same again, in any
    /// order, do nothing. The first ones of a volume come as fast as they can, but after the first only when the large
    /// image stands; later ones begin when nothing has come for a while, and take a third of the time. `parts`: of the
    /// same scan. `body`: the part of its grid that the pictures are filled with.
    void make(const std::shared_ptr<const pdr::Volume>& volume,
              const std::shared_ptr<const pdr::segment::BodyParts>& parts, const pdr::VolumeGeometry& body,
              const std::vector<pdr::app::LookTask>& tasks);
    /// No volume: what runs ends, and nothing of one is kept.
    void forget();

    /// Whether there is a large image of the volume: until then the processors are left to it. True before the first
    /// call.
    void setImageStands(bool stands) { imageStands_ = stands; }

  signals:
    /// `stops`: the brightness that the picture is shown at, which suits it.
    void made(int look, const QImage& picture, double stops);

  private:
    /// What is made of a volume once.
    struct Coarse {
        std::shared_ptr<const Volume> volume;
        std::vector<std::pair<Visible, std::shared_ptr<const Mask>>> masks;

        const std::shared_ptr<const Mask>& maskOf(const Visible& visible, const segment::BodyParts& parts,
                                                  const std::stop_token& stop);
    };

    std::weak_ptr<const Volume> volume_;  ///< of the newest tasks
    std::vector<LookTask> tasks_;
    Coarse coarse_;  ///< of that volume, as far as it is there
    std::atomic<bool> imageStands_ = true;
};

}  // namespace pdr::app
