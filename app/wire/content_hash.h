#pragma once
/// Hash of a content: keyed BLAKE2b-256 (RFC 7693). Without the key nobody can recognise a scan by its hash, or make
/// another content with the same hash.

#include <memory>
#include <span>

#include "app/wire/messages.h"

namespace pdr::wire {

/// Hashes a content incrementally.
class ContentHash {
  public:
    /// `key`: 1 to 64 bytes.
    explicit ContentHash(std::span<const std::byte> key);

    void add(std::span<const std::byte> bytes);
    /// Returns the hash; must be the last call.
    Hash finish();

  private:
    struct State;
    struct Free {
        void operator()(State* state) const;
    };
    std::unique_ptr<State, Free> state_;
};

/// Returns the hash of the sums or moments that a lease continues (Lease::kept).
Hash sumsHash(std::span<const std::byte> key, std::span<const PixelSums> sums, std::span<const Moments> moments);

/// Returns the hash of a whole content. `key`: 1 to 64 bytes.
Hash contentHash(std::span<const std::byte> key, std::span<const std::byte> bytes);

}  // namespace pdr::wire
