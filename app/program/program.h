#pragma once
/// Common frame of all programs. Each main() is one call of runProgram().

#include <functional>

namespace pdr::app {

/// Keeps the contents of memory, such as a patient's scan, out of core dumps and away from other processes of the same
/// user.
void keepMemoryPrivate();

/// Makes numbers use a decimal point in every locale, because files and other programs expect it. Must be called after
/// Qt's application object is created, which sets the locale of the user.
void keepNumbersPlain();

/// Makes the allocator return large blocks to the system when they are freed. It would otherwise keep up to some
/// hundred MB in a program that makes large images on many threads. Must be called before other threads start.
void giveMemoryBack();

/// Runs `work`, which returns the exit code, as the program `name`. An exception in any thread becomes a message on
/// standard error and exit code 1, never a signal; a file that grows beyond its size limit is an error like any other.
/// Also returns 1 if printed text could not be written, because a reader of figures from a file or a pipe must not take
/// an empty one for success.
int runProgram(const char* name, const std::function<int()>& work);

}  // namespace pdr::app
