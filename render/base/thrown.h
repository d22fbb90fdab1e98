#pragma once
/// Conversion of exceptions into errors, for the outermost function of a thread, which must let none escape.

#include <exception>
#include <new>
#include <string>

#include "render/base/errors.h"

namespace pdr {

/// Returns the exception that is being handled as an Error for the user. Call it in a catch block.
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
