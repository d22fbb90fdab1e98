#pragma once
/// The priority of threads whose work goes on for minutes beside a window that must answer within milliseconds.

namespace pdr {

/// Lowers the priority of the calling thread for good, to 5 steps of nice(1) below that of the main thread. They leave
/// it a quarter of a core beside each program that keeps one busy, and let a thread that answers the user run at once.
/// Does nothing where the system refuses.
void workInBackground();
/// Returns whether the calling thread has called workInBackground().
bool worksInBackground();

}  // namespace pdr
