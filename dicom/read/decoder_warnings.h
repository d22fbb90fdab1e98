#pragma once
/// Collects the warnings of the toolkit's decoders. A JPEG decoder that meets invalid data continues with invented
/// pixels and only writes a line into a log.

#include <string>

namespace pdr::dicom {

/// Counts the warnings of the calling thread during its lifetime; each thread may have one at a time.
class DecoderWarnings {
  public:
    DecoderWarnings();
    ~DecoderWarnings();
    DecoderWarnings(const DecoderWarnings&) = delete;
    DecoderWarnings& operator=(const DecoderWarnings&) = delete;

    int count() const { return count_; }
    /// Returns the first warning ("Corrupt JPEG data: premature end of data segment"); empty if there was none. The
    /// decoders know nothing of the patient.
    const std::string& first() const { return first_; }

    /// Sends the warnings here from now on. Must be called once, after the toolkit's log was switched off.
    static void listen();

  private:
    friend class WarningListener;
    int count_ = 0;
    std::string first_;
};

}  // namespace pdr::dicom
