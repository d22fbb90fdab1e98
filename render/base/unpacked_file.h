#pragma once
/// Reads a file from front to back, and unpacks what gzip or zlib has packed on the way.

#include <cstdint>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

#include "render/base/named_bytes.h"
#include "render/base/result.h"

namespace pdr {

/// The bytes of a plain file, or of one in memory, one after the other. Needs 32 kB whatever the file unpacks to.
class UnpackedFile {
  public:
    /// Opens `file` at its byte `start`. `isPacked`: a gzip or zlib stream begins there.
    UnpackedFile(const NamedBytes& file, std::uint64_t start, bool isPacked);
    ~UnpackedFile();
    UnpackedFile(const UnpackedFile&) = delete;
    UnpackedFile& operator=(const UnpackedFile&) = delete;

    /// Writes the next bytes to the front of `out` and returns their number, at least one; 0 at the end. Errors: those
    /// of checkPlainFile(); the packed stream is damaged, or the file ends inside it.
    Result<std::size_t> readSome(std::span<std::uint8_t> out);
    /// Fills `out` with the next bytes. Errors: those of readSome(); the file ends before.
    Result<void> read(std::span<std::uint8_t> out);
    /// Leaves out the next `count` bytes. Errors: those of read().
    Result<void> skip(std::uint64_t count);
    /// Reads on to the end of a packed stream, whose checksum stands there; does nothing for other files. Gives up
    /// without an error after `most` further bytes. Errors: those of read().
    Result<void> checkEnd(std::uint64_t most = 1 << 20);

  private:
    struct Stream;

    std::size_t readStored(std::span<std::uint8_t> out);
    void skipStored(std::uint64_t count);
    Result<std::size_t> inflateSome(std::span<std::uint8_t> out);
    Error refused(const Text& what) const;

    NamedBytes bytes_;
    std::size_t at_ = 0;  ///< the next byte in memory
    Result<void> opened_;
    std::ifstream file_;              ///< open if the bytes are not in memory
    std::unique_ptr<Stream> stream_;  ///< null: the bytes are not packed
};

}  // namespace pdr
