#pragma once
/// The functional groups of one frame of a multi-frame image (PS3.3, C.7.6.16). Only for files that use the toolkit.

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace pdr::dicom {

/// Returns the first item of a sequence; null: there is none.
inline DcmItem* firstItem(DcmItem& parent, const DcmTagKey& sequence) {
    DcmItem* item = nullptr;
    return parent.findAndGetSequenceItem(sequence, item, 0).good() ? item : nullptr;
}

/// The groups of one frame, and those that all frames share.
struct FunctionalGroups {
    DcmItem& own;
    DcmItem* shared;  ///< null: none are shared

    /// Returns what has the group; null: neither the frame nor all of them have it.
    DcmItem* holderOf(const DcmTagKey& group) const {
        return firstItem(own, group) ? &own : shared && firstItem(*shared, group) ? shared : nullptr;
    }
    /// Returns the first item of a group; null: neither the frame nor all of them have it.
    DcmItem* find(const DcmTagKey& group) const {
        DcmItem* item = firstItem(own, group);
        return item || !shared ? item : firstItem(*shared, group);
    }
};

}  // namespace pdr::dicom
