#include "dicom/read/functional_groups.h"

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace pdr::dicom {

DcmItem* firstItem(DcmItem& parent, const DcmTagKey& sequence) {
    DcmItem* item = nullptr;
    return parent.findAndGetSequenceItem(sequence, item, 0).good() ? item : nullptr;
}

DcmItem* FunctionalGroups::holderOf(const DcmTagKey& group) const {
    return firstItem(own, group) ? &own : shared && firstItem(*shared, group) ? shared : nullptr;
}

DcmItem* FunctionalGroups::find(const DcmTagKey& group) const {
    DcmItem* item = firstItem(own, group);
    return item || !shared ? item : firstItem(*shared, group);
}

}  // namespace pdr::dicom
