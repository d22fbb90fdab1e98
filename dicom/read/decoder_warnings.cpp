#include "dicom/read/decoder_warnings.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/oflog/appender.h>
#include <dcmtk/oflog/oflog.h>
#include <dcmtk/oflog/spi/logevent.h>

namespace pdr::dicom {

namespace {

/// The object that counts in this thread. Decoders run on the thread that calls them, so a warning needs no lock to
/// find its slice.
thread_local DecoderWarnings* listening = nullptr;

}  // namespace

class WarningListener : public dcmtk::log4cplus::Appender {
  public:
    ~WarningListener() override { destructorImpl(); }
    void close() override { closed = true; }

  protected:
    void append(const dcmtk::log4cplus::spi::InternalLoggingEvent& event) override {
        if (!listening)
            return;
        if (listening->count_++ == 0)
            listening->first_ = event.getMessage().c_str();
    }
};

DecoderWarnings::DecoderWarnings() {
    listening = this;
}

DecoderWarnings::~DecoderWarnings() {
    listening = nullptr;
}

void DecoderWarnings::listen() {
    const dcmtk::log4cplus::SharedAppenderPtr listener(new WarningListener);
    for (const char* decoder : {"dcmtk.dcmjpeg", "dcmtk.dcmjpls"}) {
        OFLogger logger = OFLog::getLogger(decoder);
        logger.setAdditivity(false);
        logger.addAppender(listener);
        logger.setLogLevel(OFLogger::WARN_LOG_LEVEL);
    }
}

}  // namespace pdr::dicom
