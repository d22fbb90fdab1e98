#pragma once
/// Cancels work that may take long.

#include <functional>

namespace pdr::dicom {

/// A function that the work calls now and then; false: nobody waits for the result any more.
using GoOn = std::function<bool()>;

inline bool always() {
    return true;
}

}  // namespace pdr::dicom
