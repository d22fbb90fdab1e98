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
        return notEnoughMemory("", "", phrase("Close other programs, then try again."));
    } catch (const std::exception& exception) {
        return {phrase("something failed unexpectedly: %1", std::string(exception.what())), "", phrase("Try again.")};
    } catch (...) {
        return {phrase("something failed for an unknown reason"), "", phrase("Try again.")};
    }
}

}  // namespace pdr
