#pragma once
/// Figures that the window shows for each render node, computed from its counters: whether it has work, which part of
/// its time goes into samples, and its share of the current image.
///   work   pixels times samples      times   seconds since some moment

#include <QHash>
#include <cstdint>
#include <vector>

#include "app/coordinator/node_status.h"
#include "render/tiles/worker_pool.h"
#include "ui/nodes/node_row.h"

namespace pdr::app {

/// The image that the nodes are rendering.
struct ImageInHand {
    std::uint64_t revision = 0;  ///< unique among images of the same purpose
    double pixels = 0;           ///< number of pixels; 0: there is no image
    double ownWork = 0;          ///< work that this machine has done, for all images
    Purpose purpose = Purpose::viewport;
};

class NodeFigures {
  public:
    void follow(const std::vector<nodes::NodeStatus>& nodes, const ImageInHand& image, double now);
    /// Returns the row of a node that follow() has seen, complete but for its id.
    ui::NodeRow rowOf(const nodes::NodeStatus& node) const;

    static constexpr double kWindow = 2;  ///< averaging window of rates [s]

  private:
    struct Count {
        double work = 0, busySeconds = 0;
    };
    struct Followed {
        Count now, atWindow, atImage;
        double efficiency = 0;
        bool rendering = false;
    };

    QHash<nodes::NodeId, Followed> nodes_;
    ImageInHand image_;
    double ownWorkAtImage_ = 0;
    double windowBegan_ = 0;
    double workOfImage_ = 0;  ///< work for the image by this machine and all nodes
};

}  // namespace pdr::app
