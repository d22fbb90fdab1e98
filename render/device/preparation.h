#pragma once
/// The time for which a GPU's driver translates this program, where it holds no machine code for that GPU.

#include <functional>

namespace pdr {

/// A function that is called with true before a driver translates kernels, which takes seconds, at times tens of them,
/// and with false after it; on the thread that renders.
using PreparationObserver = std::function<void(bool begins)>;

}  // namespace pdr
