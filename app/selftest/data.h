#pragma once
/// The reference cases as they stand in tests/physics/*.json; the array is written by CMake.

#include <span>

namespace pdr::selftest {

struct ReferenceFile {
    const char* name;  ///< "slab_all_orders.json"
    const char* json;
};

std::span<const ReferenceFile> referenceFiles();

}  // namespace pdr::selftest
