#pragma once
/// The ways to store a scan along the axes of the patient.

#include <algorithm>
#include <array>
#include <vector>

#include "render/base/portable.h"

namespace pdr::test {

/// Returns the 48 ways of an axis of voxels to be an axis of the patient, half of them mirrored. Columns are the
/// directions of i, j and k.
inline std::vector<dmat3> signedPermutations() {
    std::vector<dmat3> all;
    std::array axes{0, 1, 2};
    do
        for (int signs = 0; signs < 8; ++signs) {
            dmat3 axesOfVoxels(0);
            for (int i = 0; i < 3; ++i)
                axesOfVoxels[i][axes[std::size_t(i)]] = signs >> i & 1 ? -1 : 1;
            all.push_back(axesOfVoxels);
        }
    while (std::ranges::next_permutation(axes).found);
    return all;
}

}  // namespace pdr::test
