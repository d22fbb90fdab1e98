#pragma once
/// Network addresses of render nodes and coordinators as users write them. All programs parse them with this file.

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

namespace pdr {

/// Port of nodes and coordinators if none is given.
inline constexpr std::uint16_t kNodePort = 4743;

struct NetworkAddress {
    std::string host;  ///< a name in lower case, or an IP address without brackets
    std::uint16_t port = kNodePort;
};

/// What is wrong with an address.
enum class AddressFault {
    host,      ///< neither a name nor an IP address
    port,      ///< the text behind the colon is no number up to 65535
    brackets,  ///< several colons, but no IPv6 address
};

/// Parses an address: "gpu-07", "gpu-07:4743", "10.0.0.7:1", "::1", "[::1]:4743". Names consist of letters, digits,
/// dots, hyphens and underscores. Port 0 is accepted, too.
std::variant<NetworkAddress, AddressFault> readNetworkAddress(std::string_view text);

}  // namespace pdr
