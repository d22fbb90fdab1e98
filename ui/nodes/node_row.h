#pragma once
/// A remote render node as the window shows it: a plain value at one moment, without sockets or leases.
///   counts and bytes   since the node was added
///   rates and shares   of the current image

#include <QString>

namespace pdr::ui {

/// The state of a node. It takes leases when it is ready or rendering.
enum class NodeState {
    dialling,     ///< no answer yet; retried
    connecting,   ///< both sides authenticate
    waiting,      ///< waits in line: it works for other users; see `reason`
    sendingScan,  ///< the scan and the scene are being sent
    ready,        ///< has all data, and nothing to do
    rendering,
    suspect,   ///< no message for seconds; its leases are also given to other nodes
    paused,    ///< paused by the user
    draining,  ///< finishes its leases, then leaves
    lost,      ///< disconnected; other nodes render what it had not sent
    refused,   ///< does not take part; see `reason`
};

/// Failures of a node that other nodes made up for.
struct NodeFaults {
    int lost = 0;     ///< lost connections
    int overdue = 0;  ///< results that never arrived

    int all() const { return lost + overdue; }
    bool operator==(const NodeFaults&) const = default;
};

struct NodeRow {
    quint64 id = 0;   ///< does not change when the connection breaks
    QString address;  ///< "gpu-07:4743", as typed, or where it dialled in from
    QString name;     ///< the node's own name; empty: not known yet
    QString device;   ///< "cpu, 16 threads"; empty: not known yet
    NodeState state = NodeState::dialling;
    QString reason;                  ///< reason for the state, a phrase for the user; may be empty
    double scanSent = 0;             ///< part of the scan that has been sent, while sending; [0, 1]
    double iterationsPerSecond = 0;  ///< its samples, in iterations of the whole image; 0: none yet
    double efficiency = 0;           ///< E: part of its time spent on samples; (0, 1]; 0: not known
    double share = 0;                ///< part of the image's samples that it took; [0, 1]
    double latencyMs = -1;           ///< round trip time; < 0: not known
    quint64 bytesSent = 0;           ///< bytes sent to the node
    quint64 bytesReceived = 0;
    NodeFaults faults;
    bool dialledIn = false;  ///< it dialled in: after a disconnect, nobody dials it
    bool sameBits = true;    ///< its samples equal those of this machine bit by bit

    bool operator==(const NodeRow&) const = default;
};

}  // namespace pdr::ui
