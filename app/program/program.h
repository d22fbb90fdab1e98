#pragma once
/// What every program does around its work. Each main() is one call of runProgram().

#include <functional>

namespace pdr::app {

/// Keeps what is in memory, such as a patient's scan, out of core dumps and from other processes of the same user.
void keepMemoryPrivate();

/// Reads and writes numbers with a point, whatever the user's language: files and other programs expect it. Call behind
/// the application object of Qt, which takes over the language's own signs.
void keepNumbersPlain();

/// Gives the memory of large blocks back to the system when they are freed. The allocator would keep them, up to some
/// hundred MB for a program that makes large images on many threads. Call before other threads begin.
void giveMemoryBack();

/// Runs `work`, which returns the exit code, as the program `name`. Whatever is thrown, by any thread, becomes a
/// sentence on standard error and exit code 1, never a signal; a file that grows beyond its limit is
/// an error like any other. 1 as well where something that was printed did not
/// arrive: whoever reads figures from a file or a pipe must not take an empty one for success.
int runProgram(const char* name, const std::function<int()>& work);

}  // namespace pdr::app
