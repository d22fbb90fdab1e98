#include "dicom/read/codecs.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcdict.h>
#include <dcmtk/dcmdata/dcobject.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dcvr.h>
#include <dcmtk/dcmdata/dcxfer.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <dcmtk/oflog/oflog.h>

#include <mutex>

#include "dicom/read/decoder_warnings.h"

namespace pdr::dicom {

void prepareToolkit() {
    static std::once_flag once;
    std::call_once(once, [] {
        // Its log lines can carry names and birth dates.
        OFLog::configure(OFLogger::OFF_LOG_LEVEL);
        DecoderWarnings::listen();
        // Some archives write standard elements as "unknown", although the dictionary knows them.
        dcmEnableUnknownVRConversion.set(OFTrue);
        // The group length of the meta header is often wrong, and our own check of the file does not use it either.
        dcmIgnoreFileMetaInformationGroupLength.set(OFTrue);
        DcmRLEDecoderRegistration::registerCodecs();
        DJDecoderRegistration::registerCodecs(EDC_never);
        DJLSDecoderRegistration::registerCodecs();
    });
}

bool dictionaryIsThere() {
    return dcmDataDict.isDictionaryLoaded();
}

bool isCompressed(const std::string& transferSyntaxUid) {
    return DcmXfer(transferSyntaxUid.c_str()).isEncapsulated();
}

bool canDecode(const std::string& transferSyntaxUid) {
    switch (DcmXfer(transferSyntaxUid.c_str()).getXfer()) {
        case EXS_LittleEndianImplicit:
        case EXS_LittleEndianExplicit:
        case EXS_BigEndianExplicit:
        case EXS_DeflatedLittleEndianExplicit:
        case EXS_RLELossless:
        case EXS_JPEGProcess1:
        case EXS_JPEGProcess2_4:
        case EXS_JPEGProcess6_8:
        case EXS_JPEGProcess10_12:
        case EXS_JPEGProcess14:
        case EXS_JPEGProcess14SV1:
        case EXS_JPEGLSLossless:
        case EXS_JPEGLSLossy:
            return true;
        default:
            return false;
    }
}

bool codingIsLossy(const std::string& transferSyntaxUid) {
    switch (DcmXfer(transferSyntaxUid.c_str()).getXfer()) {
        case EXS_JPEGProcess1:
        case EXS_JPEGProcess2_4:
        case EXS_JPEGProcess6_8:
        case EXS_JPEGProcess10_12:
        case EXS_JPEGLSLossy:
            return true;
        default:
            return false;
    }
}

std::string transferSyntaxName(const std::string& transferSyntaxUid) {
    const DcmXfer syntax(transferSyntaxUid.c_str());
    return syntax.getXfer() == EXS_Unknown ? transferSyntaxUid : std::string(syntax.getXferName());
}

}  // namespace pdr::dicom
