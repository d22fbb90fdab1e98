#pragma once
/// What is told of render nodes in figures, made of what was counted: whether each has work, which part of its time
/// goes into samples, and what it has added to the picture in hand.
///   work   pixels times samples      times   seconds since some moment

#include <QHash>
#include <cstdint>
#include <vector>

#include "app/coordinator/node_status.h"
#include "render/tiles/worker_pool.h"
#include "ui/nodes/node_row.h"

namespace pdr::app {

/// What the nodes are at.
struct PictureInHand {
    std::uint64_t revision = 0;  ///< among those of its purpose
    double pixels = 0;           ///< 0: there is none
    double ownWork = 0;          ///< that this machine has done, of all pictures
    Purpose purpose = Purpose::viewport;
};

class NodeFigures {
  public:
    void follow(const std::vector<nodes::NodeStatus>& nodes, const PictureInHand& picture, double now);
    /// Of a node that was followed; all but its id.
    ui::NodeRow rowOf(const nodes::NodeStatus& node) const;

    static constexpr double kWindow = 2;  ///< over which rates are taken [s]

  private:
    struct Count {
        double work = 0, busySeconds = 0;
    };
    struct Followed {
        Count now, atWindow, atPicture;
        double efficiency = 0;
        bool rendering = false;
    };

    QHash<nodes::NodeId, Followed> nodes_;
    PictureInHand picture_;
    double ownWorkAtPicture_ = 0;
    double windowBegan_ = 0;
    double workOfPicture_ = 0;  ///< everybody's
};

}  // namespace pdr::app
