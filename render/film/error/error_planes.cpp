#include "render/film/error/error_planes.h"

#include <algorithm>
#include <limits>

namespace pdr {
namespace {

Tile widened(const Tile& part, int radius, ivec2 film) {
    const int left = std::max(part.x - radius, 0), top = std::max(part.y - radius, 0);
    const int right = std::min(part.x + part.width + radius, film.x);
    return {left, top, right - left, std::min(part.y + part.height + radius, film.y) - top};
}

void set(ErrorPlanes& planes, int x, int y, const PixelEstimate& pixel) {
    const auto inErrors = [](double draw, double error) { return error > 0 ? draw / error : 0; };
    const dvec3 own(inErrors(pixel.errorDraw.x, pixel.standardError.x),
                    inErrors(pixel.errorDraw.y, pixel.standardError.y),
                    inErrors(pixel.errorDraw.z, pixel.standardError.z));
    const double joint = own.x + own.y + own.z;
    planes.jointDraws.row(y)[x] = float(joint * joint);
    planes.ownDraws.row(y)[x] = float(glm::dot(own, own));
    const double error = luminance(pixel.standardError), draw = luminance(pixel.errorDraw);
    for (int c = 0; c < 3; ++c)
        planes.squares[c].row(y)[x] = float(pixel.standardError[c] * pixel.standardError[c]);
    planes.light.row(y)[x] = float(luminance(pixel.mean));
    planes.lightSquares.row(y)[x] = pixel.count < 2 ? std::numeric_limits<float>::infinity() : float(error * error);
    planes.drawSquares.row(y)[x] = float(draw * draw);
    planes.tissue.row(y)[x] = float(pixel.tissue);
}

}  // namespace

ErrorPlanes errorPlanesAround(const Film& film, const Tile& part, int radius) {
    const Tile area = widened(part, radius, film.size());
    const denoise::Plane empty(ivec2(area.width, area.height));
    ErrorPlanes planes{area, {empty, empty, empty}, empty, empty, empty, empty, empty, empty};
    denoise::eachBand(area.height, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < area.width; ++x)
                set(planes, x, y, film.pixel(area.x + x, area.y + y));
    });
    for (denoise::Plane* plane :
         {&planes.squares[0], &planes.squares[1], &planes.squares[2], &planes.light, &planes.lightSquares,
          &planes.drawSquares, &planes.tissue, &planes.jointDraws, &planes.ownDraws})
        plane->mirror();
    return planes;
}

denoise::Plane cropped(const denoise::Plane& plane, const Tile& area, const Tile& part) {
    denoise::Plane out(ivec2(part.width, part.height));
    for (int y = 0; y < part.height; ++y)
        std::copy_n(plane.row(part.y - area.y + y) + (part.x - area.x), part.width, out.row(y));
    out.mirror();
    return out;
}

}  // namespace pdr
