#pragma once
/// What fresh memory and registers hold: bytes that nobody can rely on.

#include <random>

#include "tests/ptx/base/settings.h"

namespace pdr::ptx {

class Garbage {
  public:
    explicit Garbage(const Settings& settings) : fill_(settings.fill), random_(settings.seed) {}

    void fill(void* memory, u64 bytes);

  private:
    Fill fill_;
    std::minstd_rand random_;
};

}  // namespace pdr::ptx
