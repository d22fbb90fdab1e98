#pragma once
/// The result of a scan, as plain data: no DCMTK type, no pixels.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/base/text.h"
#include "render/slice/grey_window.h"
#include "render/volume/value_unit.h"
#include "render/volume/volume.h"

namespace pdr::dicom {

class SeriesSource;

/// The person who was scanned. For display only: nothing here may reach a file, a log or the network. UTF-8.
struct PatientFacts {
    std::string name, id, birthDate, sex;

    bool operator==(const PatientFacts&) const = default;
};

/// Returns whether both are one person, as far as the files say: a typing error makes them two.
inline bool samePatient(const PatientFacts& a, const PatientFacts& b) {
    return a.name == b.name && a.id == b.id && a.birthDate == b.birthDate;
}

struct StudyFacts {
    std::string uid;  ///< as stated; reference.h has what may be cited
    std::string date, description;
};

struct SeriesFacts {
    std::string uid;  ///< as stated; reference.h has what may be cited
    std::string modality, description, date;
    int number = 0;
    /// Number of this entry within its series, from 1, if the images of the series make several entries.
    int part = 1;
    Text coding;  ///< how the slices' pixels are coded ("JPEG 2000"); empty: not known
    /// What tells the images of this entry from others of the same place ("acquisition 2"); empty: nothing.
    Text phase;
    /// Whether this entry has even slices between uneven ones of the entry that is refused for them. It is shown only
    /// if it is asked for.
    bool resampled = false;

    /// Returns what identifies this entry among all others of a scan: the UID, with "#2" behind it for the second part,
    /// and "#resampled" where slices were resampled.
    std::string id() const {
        std::string all = uid;
        if (part > 1)
            all.append("#").append(std::to_string(part));
        if (resampled)
            all.append("#resampled");
        return all;
    }
};

/// The kind of stack that the slices form.
enum class Stack {
    even,              ///< evenly spaced, upright or with a tilted gantry: can be loaded
    singleSlice,       ///< one slice has no slice distance
    gap,               ///< a slice is missing, or the distances differ
    doubled,           ///< two different slices at the same position
    tilted,            ///< the stack drifts sideways, crookedly or by more than a gantry tilts
    mixedOrientation,  ///< slices look in different directions
    mixedSize,         ///< slices differ in rows, columns or pixel spacing
    noGeometry,        ///< position, orientation or pixel spacing is absent or not a number
    notCt,             ///< localizer, colour capture, other modality, or no pixels
    unreadable,        ///< damaged, truncated or in a coding that cannot be read
};

/// A harmless remark about a series that can be loaded.
struct Note {
    std::string code;  ///< one word that images may carry: "lossy", "copies"
    Text text;         ///< a sentence for the screen; may name files
};

struct GeometryVerdict {
    Stack stack = Stack::noGeometry;
    /// A sentence that names files and millimetres ("a.dcm and b.dcm are 10 mm apart, the others 5 mm"); empty for
    /// `even`.
    Text reason;
    std::vector<Note> notes;  ///< remarks: "1 copy of a slice left out"

    bool loadable() const { return stack == Stack::even; }
};

/// What a file says about its patient and its place. Files may be overwritten between a scan and the reading of their
/// pixels: a file that says anything else then is another file, even under the same name.
struct SliceIdentity {
    PatientFacts patient;
    /// UIDs as stated, even if malformed.
    std::string studyUid, seriesUid, sopClassUid, sopInstanceUid, frameOfReferenceUid;
    std::optional<dvec3> position, rowDirection, columnDirection;  ///< as in SliceHeader
    std::optional<dvec2> spacingMm;

    bool operator==(const SliceIdentity&) const = default;
};

/// One image of a series: an object of its source, the frame in it, and what it said when it was scanned.
struct SliceRef {
    std::filesystem::path file;  ///< name of the object; the path of a file
    int frame = 0;               ///< index of the frame; 0 for single-frame objects
    SliceIdentity identity;
};

/// The grey window that files ask for (WindowCenter, WindowWidth, VOILUTFunction). It changes no HU.
struct StatedWindow {
    std::optional<GreyWindow> window;  ///< none: none is stated, or only one that cannot be used
    Text ignored;                      ///< why a stated window cannot be used, a sentence; empty: there is no such one
};

/// A slice between two measured ones, by their indices: (1 - weight) below + weight above, pixel by pixel.
struct SliceBlend {
    int below = 0, above = 0;
    double weight = 0;  ///< [0, 1]

    bool operator==(const SliceBlend&) const = default;
};

/// A series and all that identifies it. Names, numbers, dates and UIDs go to the screen and into DICOM objects of the
/// same study; none may reach a render node, a log or, unless the user asks for the patient's name on it, an image.
struct Series {
    PatientFacts patient;
    StudyFacts study;
    SeriesFacts series;
    GeometryVerdict verdict;
    /// Slices, ascending along the normal (row direction x column direction); in file order if there is no geometry.
    std::vector<SliceRef> slices;
    /// Complete for Stack::even; otherwise only `size` is set, if the slices agree on it.
    VolumeGeometry geometry;
    /// The source of the slices, which their pixels are read from; null before a scan.
    std::shared_ptr<const SeriesSource> source{};
    /// The window of the middle slice, or else of the first slice that has one.
    StatedWindow window{};
    /// The slices of the volume where they were resampled, from `slices`; empty: it has those.
    std::vector<SliceBlend> blends{};
    /// The unit of the voxels. The windows that files ask for are in values.
    ValueUnit unit{};
};

/// A file that looks like DICOM but cannot be used at all, with the reason.
struct Problem {
    std::filesystem::path file;
    Text reason;
};

struct ScanResult {
    std::vector<Series> series;     ///< loadable ones first, larger first
    std::vector<Problem> problems;  ///< damaged files, by name
    int filesSeen = 0;
    int notDicom = 0;  ///< files that were skipped because they are not DICOM
};

}  // namespace pdr::dicom
