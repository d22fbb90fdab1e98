#pragma once
/// What a scan of a folder found, as plain data. No DCMTK type, no pixels.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/base/text.h"
#include "render/volume/volume.h"

namespace pdr::dicom {

/// Who was scanned. For the screen only: nothing here may reach a file, a log or the network. UTF-8.
struct PatientFacts {
    std::string name, id, birthDate, sex;

    bool operator==(const PatientFacts&) const = default;
};

/// Whether both are one person, as far as they say: a slip of a pen makes them two.
inline bool samePatient(const PatientFacts& a, const PatientFacts& b) {
    return a.name == b.name && a.id == b.id && a.birthDate == b.birthDate;
}

struct StudyFacts {
    std::string uid, date, description;
};

struct SeriesFacts {
    std::string uid, modality, description, date;
    int number = 0;
    /// Which entry of this series it is, from 1, where its images make several entries.
    int part = 1;

    /// What tells this entry from all others of a scan: the UID, with "#2" behind it for the second part.
    std::string id() const { return part > 1 ? uid + "#" + std::to_string(part) : uid; }
};

/// What the slices are as a stack.
enum class Stack {
    even,              ///< upright and evenly spaced: can be loaded
    singleSlice,       ///< one slice has no slice distance
    gap,               ///< a slice is missing, or the distances differ
    doubled,           ///< two different slices at the same position
    tilted,            ///< the stack drifts sideways (gantry tilt)
    mixedOrientation,  ///< slices look in different directions
    mixedSize,         ///< slices differ in rows, columns or pixel spacing
    noGeometry,        ///< position, orientation or pixel spacing is absent or not a number
    notCt,             ///< localizer, colour capture, other modality, no pixels
    unreadable,        ///< damaged, truncated or in a coding that cannot be read
};

/// A harmless remark about a series that loads.
struct Note {
    std::string code;  ///< one word that pictures may carry: "lossy", "copies"
    Text text;         ///< a sentence for the screen; may name files
};

struct GeometryVerdict {
    Stack stack = Stack::noGeometry;
    /// A sentence that names files and millimetres ("a.dcm and b.dcm are 10 mm apart, the others 5 mm"); empty for
    /// `even`.
    Text reason;
    std::vector<Note> notes;  ///< "1 copy of a slice left out"

    bool loadable() const { return stack == Stack::even; }
};

/// What a file says of whom it shows and where. Files are overwritten between a scan and the reading of their pixels:
/// one that says anything else then is another one, however alike its name.
struct SliceIdentity {
    PatientFacts patient;
    std::string studyUid, seriesUid, sopInstanceUid;
    std::optional<dvec3> position, rowDirection, columnDirection;  ///< as SliceHeader
    std::optional<dvec2> spacingMm;

    bool operator==(const SliceIdentity&) const = default;
};

/// One image of a series: a file, the frame in it (0 for single-frame files), and what the file said when it was
/// scanned.
struct SliceRef {
    std::filesystem::path file;
    int frame = 0;
    SliceIdentity identity;
};

struct Series {
    PatientFacts patient;
    StudyFacts study;
    SeriesFacts series;
    GeometryVerdict verdict;
    /// Ascending along the normal (row direction x column direction). File order where there is no geometry.
    std::vector<SliceRef> slices;
    /// Meaningful for Stack::even; otherwise only `size` is filled where the slices agree on it.
    VolumeGeometry geometry;
};

/// A file that looked like DICOM but could not be used at all, with the reason.
struct Problem {
    std::filesystem::path file;
    Text reason;
};

struct ScanResult {
    std::vector<Series> series;     ///< loadable ones first, larger first
    std::vector<Problem> problems;  ///< damaged files, by name
    int filesSeen = 0;
    int notDicom = 0;  ///< files skipped because they are something else
};

}  // namespace pdr::dicom
