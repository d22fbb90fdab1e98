#pragma once
/// Examines a volume's tissue in the background: its histogram, the tissue at a place of the image, and its distance.
/// Holds the volume only while it is examined. Where the light stops in several layers (prepare/layers_under.h), the
/// layer with the greatest share is examined, and that is told; fog is refused.

#include <QObject>
#include <QPointF>
#include <QThread>
#include <atomic>
#include <memory>

#include "render/base/text.h"
#include "render/prepare/layers_under.h"
#include "render/prepare/tissue_behind.h"
#include "render/scene/scene.h"
#include "render/volume/histogram.h"

namespace pdr::app {

class TissueStudy : public QObject {
    Q_OBJECT

  public:
    TissueStudy();
    /// Waits for the work in progress.
    ~TissueStudy() override;

  public slots:
    /// Computes the histogram; ends with histogramFound(), unless another volume has come until then. Null: no volume,
    /// and no signal.
    void setVolume(const std::shared_ptr<const pdr::Volume>& volume);
    /// Finds the tissue that `scene`, which must have a volume, shows at `place`, in fractions of its width and height.
    /// Ends with tissueFound() or nothingFound(), or with neither if the volume has changed.
    void pick(const pdr::Scene& scene, QPointF place);
    /// Finds the depth of what `scene` shows at `place`. Ends with depthFound() or nothingFound(), or with neither if
    /// the volume has changed.
    void measureDepth(const pdr::Scene& scene, QPointF place);

  signals:
    void histogramFound(const std::shared_ptr<const pdr::Histogram>& histogram);
    void tissueFound(const pdr::TissueBehind& tissue);
    /// `depthMm`: along the view [mm from the eye].
    void depthFound(double depthMm);
    /// Says after tissueFound() or depthFound() which of several layers was examined.
    void layerTaken(const pdr::Text& which);
    void nothingFound(const pdr::Text& why);

  private:
    template <class Work>
    void start(Work work);
    template <class Find, class Tell>
    void look(const Scene& scene, QPointF place, Find find, Tell tell);

    std::atomic<std::uint64_t> volume_ = 0;  ///< number of the volume; results of an older one are dropped
    QThread thread_;                         ///< starts with the first work
    QObject worker_;                         ///< lives on thread_
};

}  // namespace pdr::app
