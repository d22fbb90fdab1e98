#pragma once
/// Processor time, which measures the cost of work even on a machine that runs other programs.

namespace pdr {

/// Returns the processor time that all threads of this program have used so far [s].
double processorSeconds();

}  // namespace pdr
