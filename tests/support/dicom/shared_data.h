#pragma once
/// Location of the real CT data that tests read; it is not part of the source tree.

#include <QTest>
#include <cstdlib>
#include <filesystem>

#include "tests/support/places.h"

namespace pdr::test {

/// Returns the folder that PDR_SHARED names, or `shared` beside the source tree.
inline std::filesystem::path sharedFolder() {
    const char* named = std::getenv("PDR_SHARED");
    return named ? std::filesystem::path(named) : std::filesystem::path(PDR_SOURCE_DIR) / ".." / "shared";
}

inline std::filesystem::path sharedCt() {
    return sharedFolder() / "data" / "ct";
}

}  // namespace pdr::test

/// Leaves the test function because data is missing: as skipped or, if PDR_REQUIRE_DATA is set, as failed, so that a
/// run without the data is not mistaken for one with it.
#define PDR_SKIP_FOR_WANT_OF_DATA(reason)                  \
    do {                                                   \
        if (qEnvironmentVariableIsSet("PDR_REQUIRE_DATA")) \
            QFAIL(reason);                                 \
        QSKIP(reason);                                     \
    } while (false)

/// Leaves the test function if the real data is missing.
#define PDR_NEEDS_SHARED_CT()                                  \
    if (!std::filesystem::is_directory(pdr::test::sharedCt())) \
    PDR_SKIP_FOR_WANT_OF_DATA(                                 \
        "the real CT data is not there: put it beside the source tree as shared/data, or name it in PDR_SHARED")
