#include "dicom/write/export.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/ofstd/ofuuid.h>

#include <cmath>
#include <cstdio>
#include <ctime>
#include <optional>
#include <random>
#include <system_error>

#include "dicom/read/codecs.h"
#include "render/base/errors.h"
#include "render/base/version.h"
#include "render/volume/sheared.h"
#include "render/volume/value_unit.h"

namespace pdr::dicom {

namespace fs = std::filesystem;

namespace {

/// The data that all files of the series share.
struct SeriesIdentity {
    std::string studyUid, seriesUid, frameOfReferenceUid;
    std::string date, time;
};

/// Returns a random UUID as a UID. The toolkit's own UIDs carry the address of the network card.
std::string newUid() {
    static thread_local std::random_device random;
    OFUUID::BinaryRepresentation bytes{};
    for (Uint8& byte : bytes.value)
        byte = Uint8(random());
    bytes.value[6] = (bytes.value[6] & 0x0F) | 0x40;  // version 4, RFC 4122
    bytes.value[8] = (bytes.value[8] & 0x3F) | 0x80;
    OFString uid;
    OFUUID(bytes).toString(uid, OFUUID::ER_RepresentationOID);
    return uid.c_str();
}

SeriesIdentity newIdentity() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char date[16], time[16];
    std::strftime(date, sizeof date, "%Y%m%d", &local);
    std::strftime(time, sizeof time, "%H%M%S", &local);
    return {newUid(), newUid(), newUid(), date, time};
}

/// Returns a decimal string with as many digits as 16 characters hold.
std::string decimal(double value) {
    char text[40];
    for (int digits = 16; digits > 0; --digits) {
        if (std::snprintf(text, sizeof text, "%.*g", digits, value == 0 ? 0.0 : value) <= 16)
            break;
    }
    return text;
}

std::string decimals(const dvec3& v) {
    return decimal(v.x) + '\\' + decimal(v.y) + '\\' + decimal(v.z);
}

void put(DcmItem& item, const DcmTagKey& tag, const std::string& value) {
    item.putAndInsertString(tag, value.c_str());
}

/// Returns whether rows and columns are at right angles. The step between slices may lead sideways, as with a tilted
/// gantry: each file states its own position.
bool canBeWritten(const VolumeGeometry& geometry) {
    const dvec3 row = glm::normalize(dvec3(geometry.patientFromIndex[0]));
    const dvec3 column = glm::normalize(dvec3(geometry.patientFromIndex[1]));
    return std::abs(glm::dot(row, column)) < 1e-6;
}

void putWho(DcmItem& item, const ExportFacts& facts, const SeriesIdentity& identity) {
    put(item, DCM_SpecificCharacterSet, "ISO_IR 192");
    put(item, DCM_PatientName, facts.patientName);
    put(item, DCM_PatientID, facts.patientId);
    put(item, DCM_PatientBirthDate, "");
    put(item, DCM_PatientSex, "");
    put(item, DCM_StudyInstanceUID, identity.studyUid);
    put(item, DCM_StudyDate, identity.date);
    put(item, DCM_StudyTime, identity.time);
    put(item, DCM_StudyID, "1");
    put(item, DCM_AccessionNumber, "");
    put(item, DCM_ReferringPhysicianName, "");
    put(item, DCM_StudyDescription, facts.studyDescription);
    put(item, DCM_Modality, "CT");
    put(item, DCM_SeriesInstanceUID, identity.seriesUid);
    put(item, DCM_SeriesNumber, "1");
    if (facts.bodyPart.empty())
        put(item, DCM_Laterality, "");  // type 2C: it may be one of a pair, and which is not known
    else
        put(item, DCM_BodyPartExamined, facts.bodyPart);
    put(item, DCM_SeriesDescription, facts.seriesDescription);
    put(item, DCM_Manufacturer, "PD-Render");
    put(item, DCM_SoftwareVersions, PDR_VERSION);
    put(item, DCM_FrameOfReferenceUID, identity.frameOfReferenceUid);
    put(item, DCM_PositionReferenceIndicator, "");
}

void putImage(DcmItem& item, const ExportFacts& facts, const SeriesIdentity& identity, const ValueUnit& unit, int k) {
    put(item, DCM_SOPClassUID, UID_CTImageStorage);
    put(item, DCM_SOPInstanceUID, newUid());
    put(item, DCM_ImageType, "DERIVED\\SECONDARY\\AXIAL");
    put(item, DCM_DerivationDescription, facts.derivation);
    put(item, DCM_InstanceNumber, std::to_string(k + 1));
    put(item, DCM_AcquisitionNumber, "1");
    put(item, DCM_ContentDate, identity.date);
    put(item, DCM_ContentTime, identity.time);
    put(item, DCM_KVP, "");
    put(item, DCM_RescaleIntercept, decimal(unit.zero));
    put(item, DCM_RescaleSlope, decimal(unit.step));
    put(item, DCM_RescaleType, unit.isHu ? "HU" : "US");
}

void putPlane(DcmItem& item, const VolumeGeometry& geometry, int k) {
    const dvec3 spacing = geometry.spacingMm();
    const dvec3 row = dvec3(geometry.patientFromIndex[0]) / spacing.x;
    const dvec3 column = dvec3(geometry.patientFromIndex[1]) / spacing.y;
    put(item, DCM_PatientPosition, "HFS");
    put(item, DCM_ImagePositionPatient, decimals(dvec3(geometry.patientFromIndex * dvec4(0, 0, k, 1))));
    put(item, DCM_ImageOrientationPatient, decimals(row) + '\\' + decimals(column));
    put(item, DCM_PixelSpacing, decimal(spacing.y) + '\\' + decimal(spacing.x));
    put(item, DCM_SliceThickness, decimal(sliceDrift(geometry).gapMm));
}

bool putPixels(DcmItem& item, const Volume& volume, int k) {
    const std::size_t count = std::size_t(volume.size().x) * std::size_t(volume.size().y);
    const auto slice = volume.voxels().subspan(std::size_t(k) * count, count);
    item.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    put(item, DCM_PhotometricInterpretation, "MONOCHROME2");
    item.putAndInsertUint16(DCM_Rows, Uint16(volume.size().y));
    item.putAndInsertUint16(DCM_Columns, Uint16(volume.size().x));
    item.putAndInsertUint16(DCM_BitsAllocated, 16);
    item.putAndInsertUint16(DCM_BitsStored, 16);
    item.putAndInsertUint16(DCM_HighBit, 15);
    item.putAndInsertUint16(DCM_PixelRepresentation, 1);
    const auto* words = reinterpret_cast<const Uint16*>(slice.data());
    return item.putAndInsertUint16Array(DCM_PixelData, words, static_cast<unsigned long>(count)).good();
}

std::optional<Error> writeSlice(const Volume& volume, const ExportFacts& facts, const SeriesIdentity& identity, int k,
                                const fs::path& folder) {
    char name[32];
    std::snprintf(name, sizeof name, "slice%05d.dcm", k + 1);
    const fs::path file = folder / name;
    DcmFileFormat content;
    DcmDataset& data = *content.getDataset();
    putWho(data, facts, identity);
    putImage(data, facts, identity, unitOf(volume), k);
    putPlane(data, volume.geometry(), k);
    bool written = putPixels(data, volume, k) && content.saveFile(file.c_str(), EXS_LittleEndianExplicit).good();
    // The toolkit ignores errors when it closes the file: a full disk shows in the size.
    std::error_code failure;
    const std::uintmax_t pixelBytes = 2 * std::uintmax_t(volume.size().x) * std::uintmax_t(volume.size().y);
    written = written && fs::file_size(file, failure) > pixelBytes && !failure;
    if (written)
        return {};
    return Error{phrase("slice %1 cannot be written", k + 1), folder.parent_path().string(),
                 phrase("Is the disk full, or the folder write-protected?")};
}

std::optional<Error> writeAll(const Volume& volume, const ExportFacts& facts, const fs::path& folder,
                              const Progress& progress) {
    const SeriesIdentity identity = newIdentity();
    const int count = volume.size().z;
    for (int k = 0; k < count; ++k) {
        if (!progress(double(k) / count, "writing slices"))
            return cancelled();
        if (std::optional<Error> error = writeSlice(volume, facts, identity, k, folder))
            return error;
    }
    return {};
}

std::optional<Error> refuse(const Volume& volume, const fs::path& folder) {
    std::error_code failure;
    if (fs::exists(folder, failure) && !fs::is_directory(folder, failure))
        return Error{phrase("a file of this name is in the way"), folder.string(), phrase("Choose another folder.")};
    if (fs::exists(folder, failure) && !fs::is_empty(folder, failure))
        return Error{phrase("the folder is not empty"), folder.string(), phrase("Choose an empty or a new folder.")};
    if (volume.size().x > 65535 || volume.size().y > 65535)
        return Error{phrase("a slice of more than 65535 pixels has no place in a DICOM file"), folder.string(), ""};
    if (!canBeWritten(volume.geometry()))
        return Error{phrase("the axes of the volume are not at right angles"), folder.string(),
                     phrase("Resample it first.")};
    return {};
}

/// Makes a new folder beside `place`, with a unique name. Only folders that were made here are ever removed.
std::optional<fs::path> makePartial(const fs::path& place, std::error_code& failure) {
    std::random_device random;
    if (!fs::exists(place.parent_path(), failure))
        fs::create_directories(place.parent_path(), failure);
    for (int trial = 0; trial < 100 && !failure; ++trial) {
        char suffix[24];
        std::snprintf(suffix, sizeof suffix, ".%08x.partial", unsigned(random()));
        fs::path partial = place;
        partial += suffix;
        if (fs::create_directory(partial, failure))
            return partial;
    }
    return {};
}

Error cannotBeMade(const fs::path& place, const std::error_code& failure) {
    return {phrase("the folder cannot be made (%1)", failure.message()), place.string(),
            phrase("Choose another place.")};
}

}  // namespace

Result<void> writeSeries(const Volume& volume, const ExportFacts& facts, const fs::path& folder,
                         const Progress& progress) {
    prepareToolkit();
    const fs::path target = fs::absolute(folder).lexically_normal();
    const fs::path place = target.filename().empty() ? target.parent_path() : target;
    if (std::optional<Error> error = refuse(volume, place))
        return *error;
    std::error_code failure, ignored;
    const std::optional<fs::path> partial = makePartial(place, failure);
    if (!partial)
        return cannotBeMade(place, failure);
    std::optional<Error> error = writeAll(volume, facts, *partial, progress);
    if (!error) {
        fs::rename(*partial, place, failure);
        if (failure)
            error = cannotBeMade(place, failure);
    }
    if (error) {
        fs::remove_all(*partial, ignored);
        return *error;
    }
    progress(1.0, "writing slices");
    return {};
}

}  // namespace pdr::dicom
