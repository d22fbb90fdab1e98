#pragma once
/// How work that may take long is given up.

#include <functional>

namespace pdr::dicom {

/// Asked now and then by whoever works; false: nobody waits for the result any more.
using GoOn = std::function<bool()>;

inline bool always() {
    return true;
}

}  // namespace pdr::dicom
