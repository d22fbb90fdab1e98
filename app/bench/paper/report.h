#pragma once
/// Results of the experiment for people (Markdown), for spreadsheets (CSV) and for programs (JSON).

#include <filesystem>
#include <string>

#include "app/bench/paper/figures.h"

namespace pdr::bench::paper {

/// Circumstances of the measurement.
struct Setup {
    std::string date;       ///< "2026-11-20 15:40 UTC"
    std::string version;    ///< version of this program
    std::string processor;  ///< "AMD FX-8120"
    int cores = 0;
    DeviceInfo device;
    std::string loadSource;  ///< DeviceLoad::source()
    std::string scene;       ///< "head phantom, ..."
    std::string estimator;   ///< "unbiased" or "kroesMarch"
};

struct Report {
    Setup setup;
    Plan plan;
    Measured measured;
    Figures figures;
};

std::string markdown(const Report& report);
/// Returns one line per cell; times in milliseconds, shares as fractions; unknown values are empty.
std::string csv(const Report& report);
/// Returns the same figures and the fit; times in seconds; unknown values are null.
std::string json(const Report& report);

/// Writes paper.md, paper.csv and paper.json into `folder`, each whole or not at all.
Result<void> write(const Report& report, const std::filesystem::path& folder);

}  // namespace pdr::bench::paper
