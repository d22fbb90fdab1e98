#pragma once
/// The measurements in the image, dotted where what lies in front of them hides them. Their places are dragged to what
/// the image shows where they are dropped.

#include <QTimer>

#include "app/presenters/image_pick.h"
#include "ui/measure/marks_layer.h"

namespace pdr::app {

class ImageMarks : public QObject {
    Q_OBJECT

  public:
    /// `workspace` and `scenes` must outlive this object.
    ImageMarks(const Workspace& workspace, PlaceScenes& scenes);

    ui::MarksLayer& layer() { return layer_; }
    void setMarks(const std::vector<ui::ShownMark>& marks);
    /// Finds again what hides the marks once edits rest, if `changes` may have changed that.
    void showDocument(Changes changes);
    void releaseVolume();

  signals:
    /// Reports that place `index` of a measurement was dragged to a place.
    void moved(std::uint64_t id, int index, const pdr::app::PickedPlace& place);

  private:
    void connectDrags();
    void look();
    void show(const std::vector<std::optional<HiddenBy>>& hidden);

    Workspace workspace_;
    ui::MarksLayer layer_{false};
    PlaceJob job_;
    ImagePick drops_;                    ///< finds where a place was dropped
    ui::MarkHandle dropped_;             ///< which place that is
    QTimer atRest_;                      ///< runs out when nothing has changed for a while
    std::vector<ui::ShownMark> looked_;  ///< the marks at which the job looks
};

}  // namespace pdr::app
