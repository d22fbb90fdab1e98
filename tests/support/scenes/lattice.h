#pragma once
/// A patient whose HU are known by a rule wherever one looks, and scans of him that are stored in any order.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "render/volume/volume.h"
#include "tests/support/scenes/made_volume.h"

namespace pdr::test {

/// A patient as a lattice of values, `size` of them towards his left, back and head, `spacingMm` apart.
struct Lattice {
    ivec3 size;
    dvec3 spacingMm;
    dvec3 originMm;  ///< place of the first value: right, front, feet

    /// Returns the scan whose voxels lie along the columns of `axes`, each an axis of the patient or its opposite.
    Volume stored(const dmat3& axes) const {
        VolumeGeometry geometry;
        dvec3 first(0);  // on the lattice: voxel (0, 0, 0)
        for (int i = 0; i < 3; ++i)
            for (int patient = 0; patient < 3; ++patient)
                if (axes[i][patient] != 0) {
                    geometry.size[i] = size[patient];
                    first[patient] = axes[i][patient] > 0 ? 0 : size[patient] - 1;
                    geometry.patientFromIndex[i] = dvec4(axes[i] * spacingMm[patient], 0);
                }
        geometry.patientFromIndex[3] = dvec4(originMm + first * spacingMm, 1);
        Voxels voxels;
        for (int k = 0; k < geometry.size.z; ++k)
            for (int j = 0; j < geometry.size.y; ++j)
                for (int i = 0; i < geometry.size.x; ++i) {
                    const dvec3 place = first + axes * dvec3(i, j, k);
                    voxels.push_back(madeHu(std::int64_t(place.x), std::int64_t(place.y), std::int64_t(place.z)));
                }
        return Volume(geometry, std::move(voxels));
    }

    /// Returns the HU of a place, trilinear in double, at the borders as half a step inside; NaN beyond half a step.
    double huAt(dvec3 mm) const {
        const dvec3 place = (mm - originMm) / spacingMm;
        for (int axis = 0; axis < 3; ++axis)
            if (place[axis] < -0.5 - 1e-6 || place[axis] > size[axis] - 0.5 + 1e-6)
                return std::numeric_limits<double>::quiet_NaN();
        const dvec3 inside = glm::clamp(place, dvec3(0), dvec3(size - 1));
        const dvec3 low = glm::min(glm::floor(inside), glm::max(dvec3(size - 2), dvec3(0)));
        double hu = 0;
        for (int corner = 0; corner < 8; ++corner) {
            const ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
            const ivec3 voxel = glm::min(ivec3(low) + step, size - 1);
            double share = 1;
            for (int axis = 0; axis < 3; ++axis)
                share *= step[axis] ? inside[axis] - low[axis] : 1 - (inside[axis] - low[axis]);
            hu += share * madeHu(voxel.x, voxel.y, voxel.z);
        }
        return hu;
    }
};

}  // namespace pdr::test
