#pragma once
/// What the toolkit's decoders complain about. A JPEG decoder that meets nonsense goes on with invented pixels and only
/// writes a line into a log.

#include <string>

namespace pdr::dicom {

/// Counts the complaints of the calling thread for as long as it lives; one at a time in each thread.
class DecoderWarnings {
  public:
    DecoderWarnings();
    ~DecoderWarnings();
    DecoderWarnings(const DecoderWarnings&) = delete;
    DecoderWarnings& operator=(const DecoderWarnings&) = delete;

    int count() const { return count_; }
    /// The first one ("Corrupt JPEG data: premature end of data segment"); empty if there was none. The decoders know
    /// nothing of the patient.
    const std::string& first() const { return first_; }

    /// Sends the complaints here from now on. Call once, after the toolkit's log was switched off.
    static void listen();

  private:
    friend class WarningListener;
    int count_ = 0;
    std::string first_;
};

}  // namespace pdr::dicom
