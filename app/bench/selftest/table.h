#pragma once
/// Report of the self-test: a table for the physicist who accepts a workstation with it.

#include "app/selftest/run.h"

namespace pdr::selftest {

struct TableHead {
    std::string device;  ///< "cpu, 8 threads"
    bool quick = false;
    int comparisons = 0;  ///< number of all comparisons, printed or not
    double allowed = 0;   ///< |z| that chance may reach
    std::uint64_t seed = 1;
};

/// Prints a part of the report to standard output and flushes it.
void printHead(const TableHead& head);
void printFamily(const Family& family);
void printRow(const Case& reference, const Measurement& got, const Judgement& judgement, const Sharpness& sharpness);
void printEnd(const Tally& tally, double seconds, bool brokenOff);

}  // namespace pdr::selftest
