#include <algorithm>
#include <cmath>

#include "app/bench/paper/report.h"
#include "app/bench/paper/text_table.h"

namespace pdr::bench::paper {

namespace {

std::string head(const Report& report) {
    const Setup& setup = report.setup;
    std::string text = "# Efficiency of rendering\n\n";
    if (!report.measured.complete)
        text += "**INCOMPLETE: broken off in round " + std::to_string(report.measured.rounds) + " of " +
                std::to_string(report.plan.rounds) + ".**\n\n";
    text +=
        "The experiment of Perez Monte et al., \"Estimation of Volume Rendering Efficiency with GPU in a Parallel\n"
        "Distributed Environment\", repeated with PD-Render " +
        setup.version + ", " + setup.date + ".\n\n";
    text += "* device: " + setup.device.name + ", " + setup.device.details + "\n";
    text += "* processor: " + setup.processor + ", " + std::to_string(setup.cores) + " cores\n";
    text += "* scene: " + setup.scene + "; estimator: " + setup.estimator + "\n";
    text += "* load: " + setup.loadSource + "\n";
    if (report.plan.time == TimeOf::processor)
        text += "* clock: processor time over the number of threads; what other programs took is left out\n";
    text +=
        "* K0: Exposure Render's schedule (Kroes, Post & Botha 2012), all uploaded and allocated anew for each\n"
        "  iteration; K1: without that; pd: n iterations, then one tone map and one copy, behind the next ones\n";
    const std::string seconds = plain(report.plan.seconds) + " s";
    if (report.plan.rounds == 1)
        return text + "* each figure stands on one run of about " + seconds + "\n";
    return text + "* each figure is the median of up to " + std::to_string(report.plan.rounds) + " runs, " + seconds +
           " in all, between which the others had their turn\n";
}

std::string tableTwo(const Figures& figures) {
    TextTable table({"resolution", "K0 FPS = IPS", "load", "K1 FPS = IPS", "load", "pd n=1 FPS = IPS", "load"});
    for (const SizeFigures& size : figures.sizes) {
        std::vector<std::string> row{text(size.size)};
        for (const WayPlace way : {kK0, kK1, kPd1}) {
            row.push_back(digits(size.framesPerSecond[way]));
            row.push_back(percent(size.load[way]));
        }
        table.add(row);
    }
    return "\n## Table 2. One iteration a frame\n\n" + table.text();
}

/// Returns a warning if the device was busy for too little of the time with n = 100. A device of its own hardly waits
/// then, so other programs took the rest, or it was held up.
std::string sharedDevice(const SizeFigures& largest) {
    constexpr double kAlone = 0.9;
    const std::optional<double> load = largest.load[kPd100];
    if (!load || *load >= kAlone)
        return "";
    return "\nAt " + text(largest.size) + " with n=100 the device was busy for only " + percent(load) +
           " of the time. Other programs took the rest, or it was\nheld up: these figures are not its own.\n";
}

std::string tableThree(const Report& report) {
    const Figures& figures = report.figures;
    TextTable table({"resolution", "n=10 FPS", "IPS", "load", "n=100 FPS", "IPS", "load"});
    for (const SizeFigures& size : figures.sizes) {
        std::vector<std::string> row{text(size.size)};
        for (const WayPlace way : {kPd10, kPd100}) {
            row.push_back(digits(size.framesPerSecond[way]));
            row.push_back(digits(size.iterationsPerSecond(way)));
            row.push_back(percent(size.load[way]));
        }
        table.add(row);
    }
    return "\n## Table 3. pd, more iterations a frame\n\n" + table.text() +
           (report.plan.time == TimeOf::wall ? sharedDevice(figures.sizes.front()) : "");
}

std::string tableFour(const Figures& figures) {
    TextTable table({"resolution", "T_p [ms]", "ns a pixel"});
    for (const SizeFigures& size : figures.sizes)
        table.add({text(size.size), milliseconds(size.iteration),
                   size.iteration ? digits(1e9 * *size.iteration / size.pixels()) : digits({})});
    return "\n## Table 4. Time of an iteration, T_p (eq. 6, from n=100)\n\n" + table.text();
}

bool someOtherIsNegative(const Figures& figures) {
    return std::ranges::any_of(figures.sizes, [](const SizeFigures& size) {
        return std::ranges::any_of(size.other, [](const auto& other) { return other && *other < 0; });
    });
}

std::string tableFive(const Figures& figures) {
    TextTable table({"resolution", "K0 [ms]", "K1 [ms]", "pd [ms]"});
    for (const SizeFigures& size : figures.sizes)
        table.add({text(size.size), milliseconds(size.other[kK0]), milliseconds(size.other[kK1]),
                   milliseconds(size.other[kPd1])});
    const auto& communication = figures.communication;
    return "\n## Table 5. Time of a frame beside its iterations, T_t + T_c (eq. 7, from n=1)\n\n" + table.text() +
           "\nT_c (eq. 8, from " + text(figures.sizes.back().size) + "): K0 " + milliseconds(communication[kK0]) +
           " ms, K1 " + milliseconds(communication[kK1]) + " ms, pd " + milliseconds(communication[kPd1]) + " ms.\n" +
           (someOtherIsNegative(figures)
                ? "A time below 0, and then an E above 1, is less than the error of measuring it.\n"
                : "");
}

std::string figureThree(const Figures& figures) {
    TextTable table({"resolution", "K0", "K1", "pd n=1", "pd n=10", "pd n=100"});
    for (const SizeFigures& size : figures.sizes) {
        std::vector<std::string> row{text(size.size)};
        for (const auto& efficiency : size.efficiency)
            row.push_back(fraction(efficiency));
        table.add(row);
    }
    return "\n## Figure 3. Efficiency, E (eq. 1)\n\n" + table.text();
}

/// Returns the times to an error, only for pd: the blur of Exposure Render's filter remains wrong with any number of
/// samples.
std::string accuracy(const Figures& figures) {
    TextTable table({"resolution", "samples a pixel", "pd n=1 [s]", "pd n=10 [s]", "pd n=100 [s]"});
    for (const SizeFigures& size : figures.sizes)
        table.add({text(size.size), digits(size.samplesToError()), digits(size.secondsToError(kPd1)),
                   digits(size.secondsToError(kPd10)), digits(size.secondsToError(kPd100))});
    return "\n## What accuracy costs: time to an error of " + plain(100 * kError) + " %\n\n" + table.text() +
           "\nThe error is the standard error of the pixels, root mean square, over the image's mean brightness.\n";
}

std::string goals(const Figures& figures) {
    TextTable table({"figure", "here", "goal", "paper, GTX 560 Ti"});
    for (const Goal& goal : goalsOf(figures))
        table.add({goal.what, digits(goal.here), digits(goal.wanted), digits(goal.paper)});
    return "\n## Beside the paper and the goals\n\n" + table.text();
}

std::string parameters(const FrameTimeFit& fit) {
    const FrameTimeModel& model = fit.model();
    TextTable table({"parameter", "value", "95 % from", "to"});
    const auto add = [&](const char* name, double value, const ConfidenceInterval& interval, double scale) {
        table.add({name, digits(scale * value), digits(scale * interval.low), digits(scale * interval.high)});
    };
    if (fit.launchIsKnown())
        add("T0, a launch [ms]", model.launch, fit.launch(), 1e3);
    add("alpha, a sample of a pixel [ns]", model.sample, fit.sample(), 1e9);
    add("beta, a pixel of a frame [ns]", model.pixel, fit.pixel(), 1e9);
    add(fit.launchIsKnown() ? "T_c, a frame [ms]" : "T_c + T0, a frame [ms]", model.communication, fit.communication(),
        1e3);
    if (fit.launchIsKnown())
        add("T0 + T_c, together [ms]", model.launch + model.communication, fit.floor(), 1e3);
    return table.text();
}

/// Compares eq. 5 with the measured efficiency of the smallest tile.
std::string optimism(const Figures& figures) {
    const TileEfficiency& tile = figures.tiles.back();
    std::string text = "\nAt " + paper::text(tile.size) + " with n=" + std::to_string(kWays[tile.way].iterations) +
                       " a node's E would be " + fraction(tile.manyNodes) +
                       " by eq. 5; measured against full speed it is " + fraction(tile.fraction) + " (" +
                       fraction(tile.interval.low) + " to " + fraction(tile.interval.high) + "):\n";
    if (tile.manyNodes > tile.interval.high)
        return text + "eq. 5 is optimistic here, for it takes T_p to shrink with the tile.\n";
    return text + "here eq. 5 is not optimistic beyond the error.\n";
}

std::string model(const Report& report) {
    const Figures& figures = report.figures;
    std::string text = "\n## Model: T(R, n, b) = ceil(n / b) T0 + n alpha R + beta R + T_c\n\n";
    if (!figures.fit)
        return text + "Not fitted: " + figures.whyNoFit + "\n";
    const FrameTimeFit& fit = *figures.fit;
    text += parameters(fit);
    text += "\nFitted to the medians of pd; they scatter about it by " + digits(100 * fit.scatter()) +
            " %. b = min(n, " + std::to_string(report.plan.mostPerLaunch(report.plan.sizes.back())) +
            " and what there is room for).\n\n";
    TextTable table({"tile", "n", "E, eq. 5", "E against full speed", "95 % from", "to", "T measured [ms]",
                     "T fitted [ms]", "95 % from", "to"});
    for (const TileEfficiency& tile : figures.tiles) {
        const Way& way = kWays[tile.way];
        const auto size = std::ranges::find(figures.sizes, tile.size, &SizeFigures::size);
        const FrameWork work{size->pixels(), way.iterations, report.plan.samplesPerLaunch(way, tile.size)};
        const PredictedFrame fitted = fit.predict(work);
        table.add({paper::text(tile.size), std::to_string(way.iterations), fraction(tile.manyNodes),
                   fraction(tile.fraction), fraction(tile.interval.low), fraction(tile.interval.high),
                   milliseconds(1 / *size->framesPerSecond[tile.way]), milliseconds(fitted.seconds),
                   milliseconds(fitted.interval.low), milliseconds(fitted.interval.high)});
    }
    return text + table.text() + (figures.tiles.empty() ? "" : optimism(figures));
}

std::string basis(const Report& report) {
    TextTable table({"resolution", "way", "frames", "runs", "T median [ms]", "half of the runs from", "to"}, 2);
    for (const Cell& cell : report.measured.cells) {
        std::vector<std::string> row{text(cell.size), kWays[cell.way].title(), std::to_string(cell.frames()),
                                     std::to_string(cell.runs.size())};
        const bool several = cell.runs.size() > 1;
        row.push_back(milliseconds(cell.spread().median));
        row.push_back(several ? milliseconds(cell.spread().low) : digits({}));
        row.push_back(several ? milliseconds(cell.spread().high) : digits({}));
        table.add(row);
    }
    return "\n## What the figures stand on\n\n" + table.text();
}

}  // namespace

std::string markdown(const Report& report) {
    const Figures& figures = report.figures;
    return head(report) + tableTwo(figures) + tableThree(report) + tableFour(figures) + tableFive(figures) +
           figureThree(figures) + accuracy(figures) + goals(figures) + model(report) + basis(report);
}

}  // namespace pdr::bench::paper
