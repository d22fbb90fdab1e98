#include <cstdio>
#include <vector>

#include "app/bench/commands.h"
#include "app/bench/live_image.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "app/bench/paper/head_scene.h"
#include "app/bench/turns.h"

namespace pdr::bench {

namespace {

constexpr double kHeadMm = 250;  ///< edge of the head's volume, the same for all
constexpr ivec2 kFilm{480, 320};

/// A head and the measured cost of its samples.
struct Head {
    int edge;  ///< voxels along an edge
    LiveImage image;
    std::vector<double> nanoseconds;  ///< time per sample in each round
};

Result<Head> startHead(int edge) {
    auto shown = paper::headScene(ivec3(edge), dvec3(kHeadMm / edge));
    if (!shown)
        return shown.error();
    shown->scene.film = kFilm;
    auto image = startFilm(shown->scene, "cpu", 1);
    if (!image)
        return image.error();
    return Head{edge, *std::move(image), {}};
}

}  // namespace

int sizes(const Arguments& arguments) {
    const auto options = Options::read(arguments, {"--smallest", "--largest", "--samples", "--rounds"});
    const auto number = [&](const char* name, int otherwise) {
        return options ? options->number(name, otherwise, 1) : std::nullopt;
    };
    const auto smallest = number("--smallest", 128), largest = number("--largest", 512);
    const auto samples = number("--samples", 16), rounds = number("--rounds", 5);
    if (!smallest || !largest || !samples || !rounds || *smallest > *largest || !options->files.empty())
        return 2;
    // Hold all heads in memory and measure them in turn
    std::vector<Head> heads;
    for (int edge = *smallest; edge <= *largest; edge *= 2) {
        auto head = startHead(edge);
        if (!head)
            return fail(head.error());
        heads.push_back(*std::move(head));
    }
    if (const auto taken = takeTurns(heads, kFilm, *samples, *rounds); !taken)
        return fail(taken.error());
    for (const Head& head : heads)
        std::printf("{\"voxelsPerEdge\": %d, \"nsPerSample\": %.1f, \"timesTheSmallest\": %.2f}\n", head.edge,
                    median(head.nanoseconds), median(head.nanoseconds) / median(heads.front().nanoseconds));
    return 0;
}

}  // namespace pdr::bench
