#pragma once
/// Hash of a content: keyed BLAKE2b-256 (RFC 7693). Without the key nobody can recognise a scan by its hash, or make a
/// content with the same one.

#include <memory>
#include <span>

#include "app/wire/messages.h"

namespace pdr::wire {

/// Incremental.
class ContentHash {
  public:
    /// `key`: 1 to 64 bytes.
    explicit ContentHash(std::span<const std::byte> key);

    void add(std::span<const std::byte> bytes);
    /// The last call.
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
