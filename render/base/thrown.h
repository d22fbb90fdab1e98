#pragma once
/// For the one place of each thread where nothing may be thrown any further.

#include <exception>
#include <new>
#include <string>

#include "render/base/errors.h"

namespace pdr {

/// The exception that is being handled, for the person at the screen. To be called in a catch block.
inline Error thrownError() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return notEnoughMemory("", "", "Close other programs, then try again.");
    } catch (const std::exception& exception) {
        return {std::string("something failed unexpectedly: ") + exception.what(), "", "Try again."};
    } catch (...) {
        return {"something failed for an unknown reason", "", "Try again."};
    }
}

}  // namespace pdr
