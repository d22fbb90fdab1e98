/// Measures whether the ± of a distance between two picks on an image covers what it claims: on a ball of 60 mm in a CT
/// of 0.9 x 0.9 x 2.5 mm, under four shipped looks, with clicks on the pixel that shows a known place.
///   picked_coverage [--pairs N]
/// Two lines of the surface are measured: diameters, one end seen from either side, and chords of at least 10 mm, both
/// ends seen from one side. Views and places are random; each place lies up to 60 degrees from the side seen. Three
/// ways to a place: as the light says (offEdge), moved across the edge near it, and moved along the ray to that edge
/// (onEdge), which is what the window does. Columns as in measurement_coverage, and the median ± [mm].

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <numbers>
#include <string>

#include "app/looks/looks.h"
#include "render/measure/distance.h"
#include "render/measure/picked_edge.h"
#include "render/prepare/flatten.h"
#include "render/prepare/layers_under.h"
#include "render/scene/edit/view_geometry.h"
#include "render/scene/image_setup.h"
#include "tests/support/scenes/edge_phantoms.h"
#include "tools/measure/coverage_row.h"

namespace pdr::test {
namespace {

using namespace measure;

constexpr double kRadius = 30, kAslant = 60, kShortest = 10;
constexpr int kPixels = 512;

struct Case {
    Contrast hu;
    double noiseHu;
    const char* look;
    float bloodHu;  ///< 0: the look does not ask for it
};
const Case kCases[]{{{1000, 40}, 15, "Bone", 0},
                    {{400, 40}, 20, "Bone", 0},
                    {{60, -1000}, 15, "Skin", 0},
                    {{350, -850}, 20, "Lung vessels", 350}};

/// Ways from a pick to a place.
enum class Way { light, across, along };
constexpr std::array kWays{Way::light, Way::across, Way::along};
constexpr const char* kWayNames[]{"light", "across", "along"};

struct Row : CoverageRow {
    std::vector<double> plusMinus;
};
using Rows = std::array<Row, kWays.size()>;

std::shared_ptr<const Volume> ball(const Case& about, std::mt19937& random) {
    const Scanner scanner{{0.9, 0.9, 2.5}, {0.6, 0.6, 0.9}, about.noiseHu};
    return std::make_shared<const Volume>(scanned(
        gridAround(scanner, kRadius + 9, random), scanner,
        [&](dvec3 p) {
            const double r = std::max(glm::length(p), 1e-6);
            const double share = blurredStep(kRadius - r, blurAlong(scanner, p / r));
            return std::max(about.hu.outside + (about.hu.inside - about.hu.outside) * share, -1024.0);
        },
        random));
}

/// Returns a direction up to kAslant degrees from `axis`, evenly on the sphere.
dvec3 near(dvec3 axis, std::mt19937& random) {
    for (;;)
        if (const dvec3 one = randomDirection(random); glm::dot(one, axis) > std::cos(glm::radians(kAslant)))
            return one;
}

/// The ball as seen from one side.
struct View {
    Camera camera;
    std::shared_ptr<const PreparedScene> prepared;

    View(const std::shared_ptr<const Volume>& volume, const NamedLook& look, dvec3 from, std::mt19937& random) {
        ImageSetup setup = withNamedLook(ImageSetup{}, look, volume->geometry());
        setup.clip = {};
        setup.camera = standardView(StandardView::anterior, dvec3(0), 1.5 * kRadius, 1);
        setup.camera.eyeMm = glm::length(setup.camera.eyeMm) * from;
        setup.camera.up = randomDirection(random);
        camera = setup.camera;
        prepared = Flattener().prepare(sceneOf(setup, volume, ivec2(kPixels)));
    }

    /// Returns the places of a click on the middle of the pixel that shows `mm`; none: it shows no place.
    std::optional<std::array<Place, kWays.size()>> click(const Volume& volume, dvec3 mm) const {
        const auto at = ViewGeometry(camera, 1).at(mm);
        if (!at)
            return {};
        const LayersUnder under = layersUnder(*prepared, vec2(glm::floor(*at * double(kPixels))) + 0.5f);
        if (under.seen != SeenAt::place)
            return {};
        const SeenLayer& layer = under.layers.front();
        const Place picked =
            pickedPlace(volume.geometry(), layer.placeMm, under.direction, layer.sigmaAlongMm, layer.sigmaAcrossMm);
        const EdgeSearch search = edgeNear(volume, picked.mm);
        return std::array{offEdge(picked, under.direction), search.edge ? atEdge(picked, *search.edge) : picked,
                          onEdge(volume, picked, under.direction)};
    }
};

void add(Rows& rows, const Volume& volume, double truth, const auto& from, const auto& to) {
    for (std::size_t way = 0; way < kWays.size(); ++way) {
        std::optional<Stated> found;
        if (from && to)
            found = distance(volume.geometry(), (*from)[way], (*to)[way]);
        rows[way].add(found, truth);
        if (found && found->bound == Bound::none)
            rows[way].plusMinus.push_back(found->plusMinus());
    }
}

void print(const Case& about, const char* line, Rows& rows) {
    for (std::size_t way = 0; way < kWays.size(); ++way) {
        std::vector<double>& sorted = rows[way].plusMinus;
        std::ranges::sort(sorted);
        std::printf("%-13s %5g/%-6g %-9s %-7s %5.2f ", about.look, about.hu.inside, about.hu.outside, line,
                    kWayNames[way], sorted.empty() ? NAN : sorted[sorted.size() / 2]);
        rows[way].print();
    }
}

void measure(const Case& about, const NamedLook& shipped, int pairs) {
    NamedLook look = about.bloodHu > 0 ? fittedTo(shipped, about.bloodHu) : shipped;
    look.look.visible = {};
    Rows diameters, chords;
    std::mt19937 random(11);
    for (int pair = 0; pair < pairs; ++pair) {
        const auto volume = ball(about, random);
        const dvec3 side = randomDirection(random), end = near(side, random);
        const View view(volume, look, side, random), behind(volume, look, near(-end, random), random);
        const auto first = view.click(*volume, kRadius * end);
        add(diameters, *volume, 2 * kRadius, first, behind.click(*volume, -kRadius * end));
        dvec3 other = near(side, random);
        while (kRadius * glm::distance(end, other) < kShortest)
            other = near(side, random);
        add(chords, *volume, kRadius * glm::distance(end, other), first, view.click(*volume, kRadius * other));
    }
    print(about, "diameter", diameters);
    print(about, "chord", chords);
}

}  // namespace
}  // namespace pdr::test

int main(int argc, char** argv) {
    const int pairs = argc == 3 && !std::strcmp(argv[1], "--pairs") ? std::atoi(argv[2]) : 200;
    const auto looks = pdr::app::bundledLooks();
    if (!looks)
        return 1;
    std::printf("%-13s %5s/%-6s %-9s %-7s %5s %6s %7s %7s %6s %6s %6s %6s %6s %6s\n", "look", "in", "out", "line",
                "way", "±", "stated", "at most", "lost", "bias", "SD", "±/1.96", "holds", "bounds", "untold");
    for (const pdr::test::Case& about : pdr::test::kCases)
        for (const pdr::NamedLook& shipped : *looks)
            if (shipped.name == about.look)
                pdr::test::measure(about, shipped, pairs);
    return 0;
}
