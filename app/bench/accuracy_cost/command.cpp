#include <algorithm>
#include <cstdio>
#include <iterator>

#include "app/bench/accuracy_cost/session_run.h"
#include "app/bench/commands.h"
#include "app/bench/load_scene.h"
#include "app/bench/median.h"
#include "app/bench/options.h"
#include "app/bench/paper/head_scene.h"
#include "app/bench/paper/text_table.h"

namespace pdr::bench {
namespace {

struct Row {
    Beside beside;
    Beside without;
    const char* name;
};
constexpr Row kRows[] = {{Beside::status, Beside::nothing, "status, history, forecast"},
                         {Beside::judgement, Beside::nothing, "all that is always on"},
                         {Beside::errorMap, Beside::judgement, "the error map, while open"},
                         {Beside::effectCosts, Beside::judgement, "the ledger of effects, while open"},
                         {Beside::lattice, Beside::lattice, "the bias lattice, of a march"}};
constexpr Beside kRuns[] = {Beside::nothing,  Beside::status,      Beside::judgement,
                            Beside::errorMap, Beside::effectCosts, Beside::lattice};

/// Costs of each kind of run, round by round.
class Costs {
  public:
    Result<void> addRound(const RunPlan& plan) {
        for (const Beside beside : kRuns) {
            auto costs = runSession(plan, beside);
            if (!costs)
                return costs.error();
            runs_[std::size_t(beside)].push_back(*std::move(costs));
        }
        return {};
    }
    /// Returns what `row` adds to the time of the samples until look `i`, as a share of it: the median of the rounds.
    double share(const Row& row, std::size_t i) const {
        std::vector<double> shares;
        const auto &with = of(row.beside), &without = of(row.without);
        for (std::size_t round = 0; round < with.size(); ++round) {
            const RunCost &one = with[round][i], &other = without[round][i];
            const double added = row.beside == row.without ? one.lattice : one.rest - other.rest;
            shares.push_back(added / one.sampling);
        }
        return median(shares);
    }

  private:
    using Rounds = std::vector<std::vector<RunCost>>;
    const Rounds& of(Beside beside) const { return runs_[std::size_t(beside)]; }

    Rounds runs_[std::size(kRuns)];
};

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f %%", 100 * share);
    return text;
}

void print(const Costs& costs, const RunPlan& plan) {
    std::vector<std::string> head{"beside the samples"};
    for (const std::uint64_t samples : plan.samples)
        head.push_back("to " + std::to_string(samples));
    paper::TextTable table(head);
    for (const Row& row : kRows) {
        std::vector<std::string> cells{row.name};
        for (std::size_t i = 0; i < plan.samples.size(); ++i)
            cells.push_back(percent(costs.share(row, i)));
        table.add(std::move(cells));
    }
    std::printf("%s", table.text().c_str());
}

Result<RunPlan> planOf(const std::vector<std::string>& files) {
    if (files.empty()) {
        const auto head = paper::headScene();
        if (!head)
            return head.error();
        return RunPlan{head->scene, head->display.exposure};
    }
    const auto scene = loadScene(files.front());
    if (!scene)
        return scene.error();
    return RunPlan{*scene};
}

}  // namespace

int accuracyCost(const Arguments& arguments) {
    const auto options =
        Options::read(arguments, {"--samples", "--rounds", "--iterations", "--threads", "--width", "--height"});
    const auto number = [&](const char* name, int otherwise, int least) {
        return options ? options->number(name, otherwise, least) : std::nullopt;
    };
    const auto samples = number("--samples", 256, 64), rounds = number("--rounds", 3, 1);
    const auto iterations = number("--iterations", 1, 1), threads = number("--threads", 0, 0);
    const auto width = number("--width", 480, 64), height = number("--height", 384, 64);
    if (!samples || !rounds || !iterations || !threads || !width || !height || options->files.size() > 1)
        return 2;
    auto plan = planOf(options->files);
    if (!plan)
        return fail(plan.error());
    plan->scene.film = {*width, *height};
    plan->iterations = *iterations;
    plan->threads = *threads;
    for (std::uint64_t look = 16; look <= std::uint64_t(*samples); look *= 4)
        plan->samples.push_back(look);
    std::printf(
        "Processor time beside that of the samples, in parts of it: %d x %d pixels, a frame every %d, the median of %d "
        "rounds\n\n",
        *width, *height, *iterations, *rounds);
    Costs costs;
    for (int round = 0; round < *rounds; ++round)
        if (const auto ok = costs.addRound(*plan); !ok)
            return fail(ok.error());
    print(costs, *plan);
    return 0;
}

}  // namespace pdr::bench
