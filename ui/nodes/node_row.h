#pragma once
/// A remote render node as the window shows it. A plain value, of one moment; knows no socket and no lease.
///   counts and bytes   since the node was added
///   rates and shares   of the picture in hand

#include <QString>

namespace pdr::ui {

/// What a node is doing. It takes leases when it is ready or rendering.
enum class NodeState {
    dialling,     ///< nobody answers yet; it is tried again
    connecting,   ///< each proves who it is
    sendingScan,  ///< the scan and the scene are on their way
    ready,        ///< has all that it needs, and nothing to do
    rendering,
    suspect,   ///< it has said nothing for seconds; its leases are given to others as well
    paused,    ///< by hand
    draining,  ///< it finishes what it has, and leaves
    lost,      ///< what it had not sent is rendered by others
    refused,   ///< it takes no part, for `reason`
};

/// What went wrong with a node, and was put right by others.
struct NodeFaults {
    int lost = 0;     ///< connections that broke
    int overdue = 0;  ///< results that it never brought

    int all() const { return lost + overdue; }
    bool operator==(const NodeFaults&) const = default;
};

struct NodeRow {
    quint64 id = 0;   ///< stays, however often the connection breaks
    QString address;  ///< "gpu-07:4743", as it was typed, or where it dialled in from
    QString name;     ///< as the node calls itself; empty: not known yet
    QString device;   ///< "cpu, 16 threads"; empty: not known yet
    NodeState state = NodeState::dialling;
    QString reason;                  ///< of the state, for the user: a phrase; may be empty
    double scanSent = 0;             ///< of the scan, while it is sent; [0, 1]
    double iterationsPerSecond = 0;  ///< of the whole picture, that its samples come to; 0: none yet
    double efficiency = 0;           ///< E: part of its time that went into samples; (0, 1]; 0: not known
    double share = 0;                ///< of the picture's samples, that it took; [0, 1]
    double latencyMs = -1;           ///< from a question to its answer; < 0: not known
    quint64 bytesSent = 0;           ///< to the node
    quint64 bytesReceived = 0;
    NodeFaults faults;
    bool dialledIn = false;  ///< it came by itself: when it goes, nobody dials it
    bool sameBits = true;    ///< its samples are those of this machine, bit by bit

    bool operator==(const NodeRow&) const = default;
};

}  // namespace pdr::ui
