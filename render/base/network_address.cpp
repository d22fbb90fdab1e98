#include "render/base/network_address.h"

#include <arpa/inet.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace pdr {
namespace {

using Read = std::variant<NetworkAddress, AddressFault>;

/// Returns whether `host` is an IPv6 address, with or without an interface: "fe80::1%eth0".
bool isIpv6(std::string_view host) {
    in6_addr address{};
    return ::inet_pton(AF_INET6, std::string(host.substr(0, host.find('%'))).c_str(), &address) == 1;
}

bool isName(std::string_view host) {
    const auto fits = [](char letter) {
        return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
               (letter >= '0' && letter <= '9') || letter == '.' || letter == '-' || letter == '_';
    };
    return !host.empty() && std::ranges::all_of(host, fits);
}

std::optional<std::uint16_t> portIn(std::string_view digits) {
    std::uint16_t port = 0;
    const char* end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, port);
    return error == std::errc() && stop == end ? std::optional(port) : std::nullopt;
}

/// Adds the port to a host. `rest`: the text behind the host, ":4743" or nothing.
Read withPort(std::string_view host, std::string_view rest) {
    NetworkAddress address{std::string(host)};
    std::ranges::transform(address.host, address.host.begin(),
                           [](char letter) { return letter >= 'A' && letter <= 'Z' ? char(letter + 32) : letter; });
    if (rest.empty())
        return address;
    if (rest.front() != ':')
        return AddressFault::host;
    const std::optional<std::uint16_t> port = portIn(rest.substr(1));
    if (!port)
        return AddressFault::port;
    address.port = *port;
    return address;
}

}  // namespace

Read readNetworkAddress(std::string_view text) {
    if (text.starts_with('[')) {
        const std::size_t end = text.find(']');
        const std::string_view host = text.substr(1, end == text.npos ? end : end - 1);
        return end != text.npos && isIpv6(host) ? withPort(host, text.substr(end + 1)) : AddressFault::host;
    }
    if (std::ranges::count(text, ':') > 1)
        return isIpv6(text) ? withPort(text, {}) : AddressFault::brackets;
    const std::string_view host = text.substr(0, text.find(':'));
    return isName(host) ? withPort(host, text.substr(host.size())) : AddressFault::host;
}

}  // namespace pdr
