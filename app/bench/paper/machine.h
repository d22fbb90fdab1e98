#pragma once
/// Machine and date of a report.

#include <string>

namespace pdr::bench::paper {

/// Returns "AMD EPYC 7763 64-Core Processor", or "unknown processor".
std::string processorName();
int processorCores();
/// Returns the current time: "2026-11-20 15:40 UTC".
std::string dateNow();

}  // namespace pdr::bench::paper
