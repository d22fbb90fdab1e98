#pragma once
/// Calls that fail because the settings ask for it.

#include <cuda_runtime_api.h>

#include <map>
#include <string>

#include "tests/ptx/base/settings.h"

namespace pdr::ptx {

/// PDR_PTX_FAIL: "7", call number 7 from 1; "cudaFree:2", the second cudaFree; ":719" behind either, the error's number
/// instead of cudaErrorUnknown.
class Failures {
  public:
    /// Throws NotKnown where `wanted` is none of these.
    explicit Failures(const std::string& wanted);

    /// Counts a call and returns the error that it shall end with, or cudaSuccess.
    cudaError_t next(const std::string& call);
    u64 calls() const { return all_; }

  private:
    std::string call_;  ///< empty: any
    u64 number_ = 0;    ///< 0: none
    cudaError_t error_ = cudaErrorUnknown;
    u64 all_ = 0;
    std::map<std::string, u64> byName_;
};

}  // namespace pdr::ptx
