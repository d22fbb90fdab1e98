#pragma once
/// Random access to the bytes of an object: of a file through a small window, or of memory without a copy.

#include <cstdint>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

#include "dicom/go_on.h"
#include "render/base/named_bytes.h"
#include "render/base/result.h"

namespace pdr::dicom {

class ByteSource {
  public:
    explicit ByteSource(const NamedBytes& object);
    explicit ByteSource(std::vector<std::uint8_t> bytes);

    /// Returns whether the file could be opened. Errors: it does not exist, may not be read, is not a plain file.
    const Result<void>& opened() const { return opened_; }
    std::uint64_t size() const { return size_; }

    /// Copies `out.size()` bytes from `offset` on. False if some of them do not exist.
    bool read(std::uint64_t offset, std::span<std::uint8_t> out);

  private:
    /// Returns how many of the bytes were read.
    std::size_t readFile(std::uint64_t offset, std::span<std::uint8_t> out);
    bool fillWindow(std::uint64_t offset);

    std::ifstream file_;
    std::vector<std::uint8_t> buffer_;                         ///< the window, if it is one on a file
    std::shared_ptr<const std::vector<std::uint8_t>> memory_;  ///< the window, if it is all
    std::span<const std::uint8_t> window_;
    std::uint64_t windowStart_ = 0;
    std::uint64_t size_ = 0;
    Result<void> opened_;
};

/// Returns the data set of a deflated file: everything from `offset` on, inflated. Empty if the stream is damaged,
/// inflates to more than `limit` bytes (a bomb, which costs no memory), or `goOn`, asked in each megabyte, returns
/// false.
std::vector<std::uint8_t> inflateFrom(ByteSource& source, std::uint64_t offset, std::size_t limit,
                                      const GoOn& goOn = always);

}  // namespace pdr::dicom
