#pragma once
/// How pdrender-node ends, for whoever starts it again (sysexits.h, where there is a name for it).

namespace pdr::node {

enum class ExitCode {
    done = 0,  ///< drained, or nothing to do for as long as was said
    usage = 64,
    unreachable = 69,   ///< no coordinator: try again later
    internal = 70,      ///< an error of this program: try again
    temporary = 75,     ///< the device failed: try again, elsewhere
    protocol = 76,      ///< the coordinator speaks another version of the protocol
    turnedAway = 77,    ///< the coordinator does not want this node
    configuration = 78  ///< options or certificates are wrong
};

}  // namespace pdr::node
