#pragma once
/// Texts of the reference cases, tests/physics/*.json. CMake writes the array.

#include <span>

namespace pdr::selftest {

struct ReferenceFile {
    const char* name;  ///< "slab_all_orders.json"
    const char* json;
};

std::span<const ReferenceFile> referenceFiles();

}  // namespace pdr::selftest
