#include "render/scene/sky_image.h"

#include <cmath>
#include <utility>

namespace pdr {
namespace {

/// Returns the solid angle of a row's texels together [4 pi sr].
double shareOfRow(int row, int rows) {
    return (std::cos(M_PI * row / rows) - std::cos(M_PI * (row + 1) / rows)) / 2;
}

}  // namespace

double meanLuminance(const EnvironmentImage& picture) {
    double mean = 0;
    const vec3* texel = picture.texels.data();
    for (int row = 0; row < picture.size.y; ++row) {
        double sum = 0;
        for (int column = 0; column < picture.size.x; ++column)
            sum += luminanceOf(*texel++);
        mean += shareOfRow(row, picture.size.y) * sum / picture.size.x;
    }
    return mean;
}

Result<EnvironmentImage> scaledToMeanOne(EnvironmentImage picture) {
    const double mean = meanLuminance(picture);
    if (!(mean > 0))
        return Error{phrase("the image is black and lights nothing"), "", phrase("Choose another one.")};
    for (vec3& texel : picture.texels)
        texel = vec3(dvec3(texel) / mean);
    return picture;
}

Lighting litBy(Lighting lighting, std::shared_ptr<const EnvironmentImage> picture) {
    const double before = strengthOf(lighting);
    lighting.rig.panels = {{.name = "Lamp", .from = {-0.7, 0.9, 0.9}, .radiance = 0}};
    Environment& environment = lighting.environment;
    environment.radiance = vec3(1);
    environment.nadir.reset();
    environment.rotationDegrees = 0;
    environment.image = std::move(picture);
    environment.radiance *= float((before > 0 ? before : 1) / strengthOf(lighting));
    return lighting;
}

Environment withoutImage(Environment environment) {
    environment.image = nullptr;
    environment.rotationDegrees = 0;
    return environment;
}

}  // namespace pdr
