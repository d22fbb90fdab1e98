#pragma once
/// Exit codes of pdrender-node, for supervisors that restart it. They follow sysexits.h where it has a matching code.

namespace pdr::node {

enum class ExitCode {
    done = 0,  ///< drained, or idle for too long
    usage = 64,
    unreachable = 69,   ///< no coordinator: try again later
    internal = 70,      ///< an error of this program: try again
    temporary = 75,     ///< the device failed: try again, elsewhere
    protocol = 76,      ///< the coordinator speaks another version of the protocol
    turnedAway = 77,    ///< the coordinator has refused this node
    configuration = 78  ///< options or certificates are wrong
};

}  // namespace pdr::node
