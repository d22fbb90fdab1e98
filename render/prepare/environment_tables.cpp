#include "render/prepare/environment_tables.h"

#include <cmath>
#include <span>

#include "render/base/angles.h"

namespace pdr {

namespace {

/// Returns the share of interval i in a table of ascending sums; 0 in a table without light.
float shareOf(std::span<const float> sums, int i) {
    return sums.back() > 0 ? (sums[i + 1] - sums[i]) / sums.back() : 0;
}

}  // namespace

EnvironmentTables::EnvironmentTables(std::shared_ptr<const EnvironmentImage> picture)
    : image(std::move(picture)), rowSums(1, 0.0f), density(image->texels.size()) {
    // Sum the light of the texels, row by row, weighted by their solid angle.
    const ivec2 size = image->size;
    columnSums.reserve(std::size_t(size.x + 1) * size.y);
    double light = 0;
    std::vector<double> solidAngle(size.y);
    for (int row = 0; row < size.y; ++row) {
        // The exact solid angle between two circles of latitude, also at the poles.
        solidAngle[row] =
            2 * M_PI / size.x * (sineCosine(M_PI * row / size.y).cosine - sineCosine(M_PI * (row + 1) / size.y).cosine);
        double sum = 0;
        columnSums.push_back(0);
        for (int column = 0; column < size.x; ++column) {
            const dvec3 texel(image->texels[std::size_t(row) * size.x + column]);
            brightest = glm::max(brightest, vec3(texel));
            sum += (texel.x + texel.y + texel.z) * solidAngle[row];
            columnSums.push_back(float(sum));
        }
        light += sum;
        rowSums.push_back(float(light));
    }
    for (int row = 0; row < size.y; ++row) {
        const std::span columns(columnSums.data() + std::size_t(row) * (size.x + 1), std::size_t(size.x + 1));
        const double rowShare = shareOf(rowSums, row) / solidAngle[row];
        for (int column = 0; column < size.x; ++column)
            density[std::size_t(row) * size.x + column] = float(rowShare * shareOf(columns, column));
    }
}

}  // namespace pdr
