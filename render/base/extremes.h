#pragma once
/// The smaller and the larger of two numbers in one instruction of a GPU, where min() and max() of lanes.h take two.
/// They return the same bits where `b` is a number, except for the sign of zeros: of -0 and 0 a GPU's lesser() is -0
/// and its greater() 0. What follows must not depend on that sign.

#include "render/base/lanes.h"

namespace pdr {

template <class Real>
PDR_HD inline Real lesser(Real a, Real b) {
#if defined(__CUDA_ARCH__)
    return fminf(a, b);
#else
    return min(a, b);
#endif
}

template <class Real>
PDR_HD inline Real greater(Real a, Real b) {
#if defined(__CUDA_ARCH__)
    return fmaxf(a, b);
#else
    return max(a, b);
#endif
}

}  // namespace pdr
