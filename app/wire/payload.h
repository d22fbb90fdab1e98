#pragma once
/// Payloads of messages are the parts that are too large for their maps.

#include "app/wire/messages.h"

namespace pdr::wire {

/// Returns the payload of a message, which it may move out of the message.
template <class OfType>
Bytes takePayload(OfType&) {
    return {};
}
Bytes takePayload(SceneOrder& order);
Bytes takePayload(Chunk& chunk);
Bytes takePayload(Lease& lease);
Bytes takePayload(Result& result);

/// Stores the payload in a message with valid fields. Returns what is wrong; null: nothing.
template <class OfType>
const char* givePayload(OfType&, const Bytes& payload) {
    return payload.empty() ? nullptr : "it has more bytes than such a message";
}
const char* givePayload(SceneOrder& order, const Bytes& payload);
const char* givePayload(Chunk& chunk, Bytes payload);
const char* givePayload(Lease& lease, const Bytes& payload);
const char* givePayload(Result& result, const Bytes& payload);

}  // namespace pdr::wire
