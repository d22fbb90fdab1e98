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

#include <algorithm>
#include <mutex>

#include "dicom/read/decoder_warnings.h"

namespace pdr::dicom {
namespace {

struct Jpeg2000Syntax {
    const char* uid;
    const char* name;
    bool isLossless;
};
/// The transfer syntaxes of DICOM PS3.5, A.4.4 and A.4.12; the toolkit does not know all of them.
constexpr Jpeg2000Syntax kJpeg2000[]{
    {"1.2.840.10008.1.2.4.90", "JPEG 2000 (lossless only)", true},
    {"1.2.840.10008.1.2.4.91", "JPEG 2000", false},
    {"1.2.840.10008.1.2.4.201", "High-Throughput JPEG 2000 (lossless only)", true},
    {"1.2.840.10008.1.2.4.202", "High-Throughput JPEG 2000 (RPCL, lossless only)", true},
    {"1.2.840.10008.1.2.4.203", "High-Throughput JPEG 2000", false},
};

/// Returns the entry of a transfer syntax; null: it is not JPEG 2000.
const Jpeg2000Syntax* jpeg2000(const std::string& uid) {
    const auto* found = std::ranges::find(kJpeg2000, uid, &Jpeg2000Syntax::uid);
    return found == std::end(kJpeg2000) ? nullptr : found;
}

}  // namespace

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

bool isJpeg2000(const std::string& transferSyntaxUid) {
    return jpeg2000(transferSyntaxUid) != nullptr;
}

bool codingMayLose(const std::string& transferSyntaxUid) {
    const Jpeg2000Syntax* syntax = jpeg2000(transferSyntaxUid);
    return syntax && !syntax->isLossless;
}

bool isCompressed(const std::string& transferSyntaxUid) {
    return isJpeg2000(transferSyntaxUid) || DcmXfer(transferSyntaxUid.c_str()).isEncapsulated();
}

bool isBigEndian(const std::string& transferSyntaxUid) {
    return DcmXfer(transferSyntaxUid.c_str()).getPixelDataByteOrder() == EBO_BigEndian;
}

bool isGeBigEndian(const std::string& transferSyntaxUid) {
    return DcmXfer(transferSyntaxUid.c_str()).getXfer() == EXS_PrivateGE_LEI_WithBigEndianPixelData;
}

bool isDeflated(const std::string& transferSyntaxUid) {
    return DcmXfer(transferSyntaxUid.c_str()).getXfer() == EXS_DeflatedLittleEndianExplicit;
}

bool canDecode(const std::string& transferSyntaxUid) {
    if (isJpeg2000(transferSyntaxUid))
        return true;
    switch (DcmXfer(transferSyntaxUid.c_str()).getXfer()) {
        case EXS_LittleEndianImplicit:
        case EXS_LittleEndianExplicit:
        case EXS_BigEndianExplicit:
        case EXS_PrivateGE_LEI_WithBigEndianPixelData:
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
    if (const Jpeg2000Syntax* jpeg = jpeg2000(transferSyntaxUid))
        return jpeg->name;
    const DcmXfer syntax(transferSyntaxUid.c_str());
    return syntax.getXfer() == EXS_Unknown ? transferSyntaxUid : std::string(syntax.getXferName());
}

Text codingName(const std::string& transferSyntaxUid) {
    const std::string name = transferSyntaxName(transferSyntaxUid);
    if (isJpeg2000(transferSyntaxUid))
        return std::string(name.starts_with("High") ? "HTJ2K" : "JPEG 2000");
    switch (DcmXfer(transferSyntaxUid.c_str()).getXfer()) {
        case EXS_LittleEndianImplicit:
        case EXS_LittleEndianExplicit:
        case EXS_BigEndianExplicit:
        case EXS_PrivateGE_LEI_WithBigEndianPixelData:
            return phrase("uncompressed");
        case EXS_DeflatedLittleEndianExplicit:
            return std::string("Deflate");
        case EXS_RLELossless:
            return std::string("RLE");
        case EXS_JPEGProcess1:
        case EXS_JPEGProcess2_4:
        case EXS_JPEGProcess6_8:
        case EXS_JPEGProcess10_12:
            return std::string("JPEG");
        case EXS_JPEGProcess14:
        case EXS_JPEGProcess14SV1:
            return phrase("JPEG lossless");
        case EXS_JPEGLSLossless:
        case EXS_JPEGLSLossy:
            return std::string("JPEG-LS");
        default:
            return name;
    }
}

}  // namespace pdr::dicom
