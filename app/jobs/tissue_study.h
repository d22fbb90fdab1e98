#pragma once
/// What is to be known of a volume's tissue, found beside the window: its histogram, and what lies under a place of the
/// picture, and how far away. A volume is held while it is looked at only.

#include <QObject>
#include <QPointF>
#include <QThread>
#include <atomic>
#include <memory>

#include "render/prepare/focus.h"
#include "render/scene/scene.h"
#include "render/volume/histogram.h"

namespace pdr::app {

class TissueStudy : public QObject {
    Q_OBJECT

  public:
    TissueStudy();
    /// Waits for what runs.
    ~TissueStudy() override;

  public slots:
    /// Ends with histogramFound(), unless another volume has come until then. Null: no volume, and no signal.
    void setVolume(const std::shared_ptr<const pdr::Volume>& volume);
    /// What `scene`, which has a volume, shows at `place`, in fractions of its width and height. Ends with
    /// tissueFound(), or nothingFound(); with neither when the volume has gone.
    void pick(const pdr::Scene& scene, QPointF place);
    /// How far away is what `scene` shows there. Ends with depthFound(), or as pick() does.
    void measureDepth(const pdr::Scene& scene, QPointF place);

  signals:
    void histogramFound(const std::shared_ptr<const pdr::Histogram>& histogram);
    void tissueFound(const pdr::TissueUnder& tissue);
    /// Along the view [mm from the eye].
    void depthFound(double depthMm);
    void nothingFound();

  private:
    template <class Work>
    void start(Work work);
    template <class Find, class Tell>
    void look(const Scene& scene, QPointF place, Find find, Tell tell);

    std::atomic<std::uint64_t> volume_ = 0;  ///< number of the volume; what belongs to an older one is dropped
    QThread thread_;                         ///< begins with the first work
    QObject worker_;                         ///< lives on thread_
};

}  // namespace pdr::app
