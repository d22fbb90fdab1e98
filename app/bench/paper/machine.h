#pragma once
/// What a report says about where and when it came about.

#include <string>

namespace pdr::bench::paper {

/// "AMD EPYC 7763 64-Core Processor", or "unknown processor".
std::string processorName();
int processorCores();
/// "2026-11-20 15:40 UTC"
std::string dateNow();

}  // namespace pdr::bench::paper
