#pragma once
/// What an acted peer has heard.

#include <variant>
#include <vector>

#include "app/wire/messages.h"

namespace pdr::test {

/// Returns all messages of a kind, in the order in which they arrived.
template <class Kind>
std::vector<Kind> heardIn(const std::vector<wire::Message>& received) {
    std::vector<Kind> all;
    for (const wire::Message& message : received)
        if (const auto* one = std::get_if<Kind>(&message))
            all.push_back(*one);
    return all;
}

}  // namespace pdr::test
