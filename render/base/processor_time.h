#pragma once
/// What work costs on a machine that others use too.

namespace pdr {

/// Processor time that all threads of this program have taken so far [s].
double processorSeconds();

}  // namespace pdr
