#include <cstdio>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "app/bench/paper/head_scene.h"
#include "app/bench/turns.h"
#include "render/prepare/flatten.h"

namespace pdr::bench {

namespace {

constexpr double kHeadMm = 250;  ///< edge of the head's volume
constexpr ivec2 kFilm{480, 320};

/// What the voxels of a head are divided into.
struct Division {
    int parts;
    bool byColour;  ///< parts differ in their colour, else in their opacity
};
constexpr Division kDivisions[] = {{0, false},   {1, false},   {4, false}, {16, false},
                                   {100, false}, {255, false}, {100, true}};

/// Returns `u` with its bits behind the point mirrored to another base: the u-th of places that fill [0, 1] evenly.
double radicalInverse(int base, int u) {
    double inverse = 0, digit = 1;
    for (; u > 0; u /= base) {
        digit /= base;
        inverse += digit * (u % base);
    }
    return inverse;
}

/// The place that a part is nearest to.
struct Place {
    vec3 at;
    std::uint8_t label;
};

/// Returns those of the places that may be the nearest one of a voxel from `low` to `high`.
std::vector<Place> nearPlaces(const std::vector<Place>& places, ivec3 low, ivec3 high) {
    const vec3 middle = 0.5f * vec3(low + high);
    const float radius = glm::distance(middle, vec3(high));
    const auto far = [&](const Place& place) { return glm::distance(place.at, middle); };
    const float nearest = far(*std::ranges::min_element(places, {}, far));
    std::vector<Place> near;
    std::ranges::copy_if(places, std::back_inserter(near),
                         [&](const Place& place) { return far(place) <= nearest + 2.001f * radius; });
    return near;
}

/// Divides all voxels among `count` parts: each belongs to the nearest of as many places.
std::shared_ptr<const LabelMap> divided(const VolumeGeometry& grid, int count) {
    auto map = std::make_shared<LabelMap>();
    map->geometry = grid;
    map->parts.resize(std::size_t(count));
    map->labels.reserve(grid.voxelCount());
    std::vector<Place> places;
    for (int n = 1; n <= count; ++n)
        places.push_back({vec3(grid.size) * vec3(float(radicalInverse(2, n)), float(radicalInverse(3, n)),
                                                 float(radicalInverse(5, n))),
                          std::uint8_t(n)});
    constexpr int kRun = 8;  // voxels along x that are divided together
    for (int k = 0; k < grid.size.z; ++k)
        for (int j = 0; j < grid.size.y; ++j)
            for (int i = 0; i < grid.size.x; i += kRun) {
                const int end = std::min(i + kRun, grid.size.x);
                const std::vector<Place> near = nearPlaces(places, {i, j, k}, {end - 1, j, k});
                for (int x = i; x < end; ++x) {
                    const auto far = [&](const Place& place) { return glm::distance(place.at, vec3(x, j, k)); };
                    map->labels.push_back(std::ranges::min_element(near, {}, far)->label);
                }
            }
    return map;
}

/// Gives the head parts that differ so little that light goes the same way in all of them.
void giveParts(Scene& scene, const Division& division) {
    if (division.parts == 0)
        return;
    scene.parts.map = divided(scene.volume->geometry(), division.parts);
    for (int label = 1; label <= division.parts; ++label) {
        PartCurve part{std::uint8_t(label), scene.transferFunction};
        const float less = 1 - 1e-4f * float(label);
        if (division.byColour)
            for (TransferNode& node : part.transferFunction.nodes)
                node.albedo *= less;
        else
            part.transferFunction.extinctionPerMm *= less;
        scene.parts.curves.push_back(std::move(part));
    }
}

/// A head of a number of parts, and what it costs.
struct Head {
    Division division;
    std::size_t labelBytes;  ///< bytes of the labels of voxels and the curves of cells
    std::size_t curveBytes;  ///< bytes of the tables of all curves
    LiveImage image;
    std::vector<double> nanoseconds;  ///< time per sample in each round
};

std::size_t curveBytes(const PartTables& tables) {
    return std::as_bytes(std::span(tables.pieces)).size() + std::as_bytes(std::span(tables.materials)).size() +
           std::as_bytes(std::span(tables.pieceAt)).size() + std::as_bytes(std::span(tables.curves)).size();
}

Result<Head> startHead(int edge, const Division& division) {
    auto shown = paper::headScene(ivec3(edge), dvec3(kHeadMm / edge));
    if (!shown)
        return shown.error();
    Scene& scene = shown->scene;
    scene.film = kFilm;
    giveParts(scene, division);
    const auto prepared = Flattener().flatten(scene);
    auto image = startFilm(scene, "cpu", 1);
    if (!image)
        return image.error();
    const PartTables& tables = prepared->parts;
    const std::size_t labels = tables.empty() ? 0 : tables.map->labels.size() + tables.cells->size();
    return Head{division, labels, curveBytes(tables), *std::move(image), {}};
}

/// Returns the median of a head's time over that of the head without parts, which took its turn just before or after.
double timesNone(const Head& head, const Head& none) {
    std::vector<double> times;
    for (std::size_t round = 0; round < head.nanoseconds.size(); ++round)
        times.push_back(head.nanoseconds[round] / none.nanoseconds[round]);
    return median(times);
}

void printText(const std::vector<Head>& heads) {
    std::puts("parts  differ in  ns a sample  times none  labels [MB]  a curve [kB]");
    for (const Head& head : heads) {
        const auto& [parts, byColour] = head.division;
        std::printf("%5d  %9s  %11.1f  %10.3f  %11.2f  %12.2f\n", parts, byColour ? "colour" : "opacity",
                    median(head.nanoseconds), timesNone(head, heads.front()), double(head.labelBytes) / 1e6,
                    double(head.curveBytes) / 1e3 / (parts + 1));
    }
}

void printJson(const std::vector<Head>& heads) {
    for (const Head& head : heads) {
        const nlohmann::ordered_json json{{"parts", head.division.parts},
                                          {"byColour", head.division.byColour},
                                          {"nsPerSample", median(head.nanoseconds)},
                                          {"timesNone", timesNone(head, heads.front())},
                                          {"labelBytes", head.labelBytes},
                                          {"curveBytes", head.curveBytes}};
        std::puts(json.dump().c_str());
    }
}

}  // namespace

int parts(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--size", "--samples", "--rounds"}, {"--json"});
    const auto number = [&](const char* name, int otherwise) {
        return options ? options->number(name, otherwise, 1) : std::nullopt;
    };
    const auto size = number("--size", 256), samples = number("--samples", 4), rounds = number("--rounds", 9);
    if (!size || !samples || !rounds || !options->files.empty())
        return 2;
    // Hold all heads in memory and measure them in turn
    std::vector<Head> heads;
    for (const Division& division : kDivisions) {
        auto head = startHead(*size, division);
        if (!head)
            return fail(head.error());
        heads.push_back(*std::move(head));
    }
    if (const auto taken = takeTurns(heads, kFilm, *samples, *rounds); !taken)
        return fail(taken.error());
    options->named.contains("--json") ? printJson(heads) : printText(heads);
    return 0;
}

}  // namespace pdr::bench
