#pragma once
/// The functional groups of one frame of a multi-frame image (PS3.3, C.7.6.16).

class DcmItem;
class DcmTagKey;

namespace pdr::dicom {

/// Returns the first item of a sequence; null: there is none.
DcmItem* firstItem(DcmItem& parent, const DcmTagKey& sequence);

/// The groups of one frame, and those that all frames share.
struct FunctionalGroups {
    DcmItem& own;
    DcmItem* shared;  ///< null: none are shared

    /// Returns what has the group; null: neither the frame nor all of them have it.
    DcmItem* holderOf(const DcmTagKey& group) const;
    /// Returns the first item of a group; null: neither the frame nor all of them have it.
    DcmItem* find(const DcmTagKey& group) const;
};

}  // namespace pdr::dicom
