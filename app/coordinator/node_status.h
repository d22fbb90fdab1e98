#pragma once
/// Status of a render node, for display.

#include <QString>
#include <cstdint>
#include <optional>
#include <vector>

#include "render/tiles/worker.h"

namespace pdr::nodes {

/// Identifies a node for as long as the program runs.
using NodeId = std::uint32_t;

enum class NodeState {
    dialling,  ///< not reached yet; dialled again and again
    greeting,  ///< connected, in the handshake
    waiting,   ///< waits in line: the node works for other coordinators
    sending,   ///< the scene is being sent
    ready,
    suspect,  ///< silent for some seconds
    paused,
    draining,
    quarantined,  ///< it has sent a wrong result
    refused,      ///< it was refused (version, bits, certificate)
    lost          ///< disconnected; redialled if it was dialled
};

struct NodeStatus {
    NodeId id = 0;
    QString address;         ///< address as given, or the peer address of a node that dialled
    bool dialled = false;    ///< true: this program dials the node; false: the node dialled
    QString name, device;    ///< as the node reports them: "gpu-07", "cpu, 16 threads"
    bool otherBits = false;  ///< its samples differ from those of the own device: it is refused
    NodeState state = NodeState::dialling;
    Text reason;                      ///< reason for the state; empty: none
    bool saidGoodbye = false;         ///< the last connection ended with a Bye
    double sent = 0;                  ///< part of the content being sent that has been queued; [0, 1]
    std::optional<double> latencyMs;  ///< round-trip time
    std::int64_t bytesOut = 0, bytesIn = 0;
    std::uint32_t losses = 0;  ///< connections lost without a Bye
    WorkerStatus work;
};

}  // namespace pdr::nodes
