#pragma once
/// Where a render node or a coordinator is reached, as a hand writes it. Read here alone, for all programs.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace pdr {

/// Port of nodes and coordinators where none is given.
inline constexpr std::uint16_t kNodePort = 4743;

struct NetworkAddress {
    std::string host;  ///< a name in small letters, or an IP address without brackets
    std::uint16_t port = kNodePort;
};

/// What is wrong with an address.
enum class AddressFault {
    host,      ///< neither a name nor an IP address
    port,      ///< what stands behind the colon is no number up to 65535
    brackets,  ///< several colons, and no IPv6 address
};

/// "gpu-07", "gpu-07:4743", "10.0.0.7:1", "::1", "[::1]:4743". Names have letters, digits, dots, hyphens and
/// underscores. Port 0 is read, too.
std::variant<NetworkAddress, AddressFault> readNetworkAddress(std::string_view text);

}  // namespace pdr
