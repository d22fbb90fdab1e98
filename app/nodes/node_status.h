#pragma once
/// What the user is told of a render node.

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/tiles/worker.h"

namespace pdr::nodes {

/// What a user refers to a node by, as long as the program runs.
using NodeId = std::uint32_t;

enum class NodeState {
    dialling,  ///< it cannot be reached yet; tried again
    greeting,  ///< connected; who it is is not known yet
    sending,   ///< it gets the scene
    ready,
    suspect,  ///< not heard of for some seconds
    paused,
    draining,
    quarantined,  ///< it has sent what is not true
    refused,      ///< it cannot work for this program
    lost          ///< it has gone; a dialled one is tried again
};

struct NodeStatus {
    NodeId id = 0;
    QString address;         ///< as it was given, or from where it dialled
    bool dialled = false;    ///< by this program, which goes on trying
    QString name, device;    ///< as it says itself: "gpu-07", "cpu, 16 threads"
    bool otherBits = false;  ///< its samples differ from those of the own device: it is refused
    NodeState state = NodeState::dialling;
    QString reason;                   ///< of the state; empty: none
    double sent = 0;                  ///< of the scene's contents; [0, 1]
    std::optional<double> latencyMs;  ///< from a ping to its answer
    std::int64_t bytesOut = 0, bytesIn = 0;
    std::uint32_t losses = 0;  ///< of its connection
    WorkerStatus work;
};

}  // namespace pdr::nodes
