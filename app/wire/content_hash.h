#pragma once
/// What names a content: BLAKE2b-256, keyed (RFC 7693), so that who does not know the key can neither recognise a scan
/// by it nor make another one of the same name.

#include <memory>
#include <span>

#include "app/wire/messages.h"

namespace pdr::wire {

/// Of parts, one behind the other.
class ContentHash {
  public:
    /// `key`: 1 to 64 bytes.
    explicit ContentHash(std::span<const std::byte> key);

    void add(std::span<const std::byte> bytes);
    /// Nothing may be added after it.
    Hash finish();

  private:
    struct State;
    struct Free {
        void operator()(State* state) const;
    };
    std::unique_ptr<State, Free> state_;
};

Hash contentHash(std::span<const std::byte> key, std::span<const std::byte> bytes);

}  // namespace pdr::wire
