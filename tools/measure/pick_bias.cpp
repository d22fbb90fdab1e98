/// Measures how far from a known surface a click finds a place (render/prepare/layers_under.h): a ball of 30 mm in air
/// or soft tissue, blurred and noisy as a CT of 0.9 x 0.9 x 2.5 mm is, seen from six sides under shipped looks.
///   pick_bias
/// Prints a line for each pair of tissues, of all clicks that meet the surface up to 75 degrees aslant: how many find a
/// place; its mean distance behind the surface along the ray and the standard deviation; the same up to 45 degrees; and
/// the median of the standard deviation that is stated.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "app/looks/looks.h"
#include "render/prepare/flatten.h"
#include "render/prepare/layers_under.h"
#include "render/scene/edit/view_geometry.h"
#include "render/scene/image_setup.h"

namespace pdr::test {
namespace {

constexpr double kRadius = 30;

struct Case {
    double insideHu, outsideHu, noiseHu;
    const char* look;
    float bloodHu;  ///< 0: the look does not ask for it
};

/// Noise as a CT has: correlated between neighbours in a slice, with the standard deviation 1.
std::vector<double> noiseOf(ivec3 size, std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::vector<double> raw(std::size_t(size.x) * size.y * size.z), smooth(raw.size());
    for (double& value : raw)
        value = normal(random);
    const auto at = [&](int i, int j, int k) {
        return raw[(std::size_t(k) * size.y + std::clamp(j, 0, size.y - 1)) * size.x + std::clamp(i, 0, size.x - 1)];
    };
    double squares = 0;
    std::size_t next = 0;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                double sum = 0;
                for (int b = -1; b <= 1; ++b)
                    for (int a = -1; a <= 1; ++a)
                        sum += at(i + a, j + b, k) * (a == 0 ? 1 : 0.5) * (b == 0 ? 1 : 0.5);
                smooth[next++] = sum;
                squares += sum * sum;
            }
    for (double& value : smooth)
        value /= std::sqrt(squares / double(smooth.size()));
    return smooth;
}

/// Makes the ball about `middle`, blurred by 0.6 mm in the slice and 0.9 mm across.
std::shared_ptr<const Volume> ball(const Case& about, dvec3 middle, std::mt19937& random) {
    const ivec3 size(100, 100, 40);
    const dvec3 spacing(0.9, 0.9, 2.5);
    const VolumeGeometry geometry = VolumeGeometry::aligned(size, spacing, -0.5 * dvec3(size - 1) * spacing);
    const std::vector<double> noise = noiseOf(size, random);
    Voxels voxels;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const dvec3 from = dvec3(geometry.patientFromIndex * dvec4(i, j, k, 1)) - middle;
                const double distance = std::max(glm::length(from), 1e-9), aslant = from.z / distance;
                const double blur = std::sqrt(0.36 * (1 - aslant * aslant) + 0.81 * aslant * aslant);
                const double inside = 0.5 * (1 + std::erf((kRadius - distance) / blur / std::sqrt(2.0)));
                const double hu = about.outsideHu + (about.insideHu - about.outsideHu) * inside +
                                  about.noiseHu * noise[voxels.size()];
                voxels.push_back(std::int16_t(std::lround(std::clamp(hu, -1024.0, 3071.0))));
            }
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

/// A point of the surface that a line of sight meets first.
struct Met {
    double along;    ///< mm from the line's origin
    double degrees;  ///< between the line and the surface's normal
};

std::optional<Met> surfaceOn(const SightLine& line, dvec3 middle) {
    const dvec3 from = line.originMm - middle;
    const double half = glm::dot(from, line.direction);
    const double root = half * half - glm::dot(from, from) + kRadius * kRadius;
    if (root < 0)
        return std::nullopt;
    const double along = -half - std::sqrt(root);
    const double cosine = -glm::dot(from + line.direction * along, line.direction) / kRadius;
    return Met{along, glm::degrees(std::acos(std::min(cosine, 1.0)))};
}

/// Mean and standard deviation of numbers.
struct Spread {
    double count = 0, sum = 0, squares = 0;

    void add(double value) {
        ++count;
        sum += value;
        squares += value * value;
    }
    double mean() const { return sum / count; }
    double deviation() const { return std::sqrt(std::max(squares / count - mean() * mean(), 0.0)); }
};

struct Found {
    int clicks = 0;
    Spread all, upright;
    std::vector<double> stated;
};

void look(const Scene& scene, dvec3 middle, Found& found) {
    const auto prepared = Flattener().prepare(scene);
    const ViewGeometry view(scene.camera, 1);
    for (int y = 2; y < scene.film.y; y += 3)
        for (int x = 2; x < scene.film.x; x += 3) {
            const vec2 place = vec2(x, y) + 0.5f;
            const SightLine line = view.under(dvec2(place) / dvec2(scene.film));
            const std::optional<Met> met = surfaceOn(line, middle);
            if (!met || met->degrees > 75)
                continue;
            ++found.clicks;
            const LayersUnder under = layersUnder(*prepared, place);
            if (under.seen != SeenAt::place)
                continue;
            const double off = glm::dot(under.layers[0].placeMm - line.originMm, line.direction) - met->along;
            found.all.add(off);
            if (met->degrees < 45)
                found.upright.add(off);
            found.stated.push_back(under.layers[0].sigmaAlongMm);
        }
}

void measure(const Case& about, const NamedLook& shipped) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    NamedLook look = about.bloodHu > 0 ? fittedTo(shipped, about.bloodHu) : shipped;
    look.look.visible = {};
    Found found;
    for (int side = 0; side < 6; ++side) {
        const dvec3 middle(0.9 * unit(random), 0.9 * unit(random), 2.5 * unit(random));
        const auto volume = ball(about, middle, random);
        ImageSetup setup = withNamedLook(ImageSetup{}, look, volume->geometry());
        setup.clip = {};
        setup.camera = standardView(StandardView(side), middle, 1.5 * kRadius, 1);
        test::look(sceneOf(setup, volume, ivec2(256)), middle, found);
    }
    std::ranges::sort(found.stated);
    std::printf("%-22s %5.0f in %5.0f HU, noise %2.0f | %5.1f | %+5.2f %4.2f | %+5.2f %4.2f | %4.2f\n", about.look,
                about.insideHu, about.outsideHu, about.noiseHu, 100 * found.all.count / found.clicks, found.all.mean(),
                found.all.deviation(), found.upright.mean(), found.upright.deviation(),
                found.stated.empty() ? 0 : found.stated[found.stated.size() / 2]);
    std::fflush(stdout);
}

}  // namespace
}  // namespace pdr::test

int main() {
    using namespace pdr;
    const auto looks = app::bundledLooks();
    if (!looks)
        return 1;
    std::printf("%-48s | found | bias   SD | to 45 degrees | stated\n", "look, ball");
    for (const test::Case& about : {test::Case{1000, 40, 0, "Bone", 0},
                                    {1000, 40, 15, "Bone", 0},
                                    {1000, 40, 40, "Bone", 0},
                                    {400, 40, 20, "Bone", 0},
                                    {60, -1000, 15, "Skin", 0},
                                    {60, -1000, 40, "Skin", 0},
                                    {350, 40, 15, "Vessels and bone", 350},
                                    {350, 40, 30, "Vessels and bone", 350},
                                    {350, -850, 20, "Lung vessels", 350}})
        for (const NamedLook& shipped : *looks)
            if (shipped.name == about.look)
                test::measure(about, shipped);
    return 0;
}
