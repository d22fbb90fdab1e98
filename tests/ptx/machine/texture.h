#pragma once
/// Textures of volumes, filtered as the CUDA C++ Programming Guide says (appendix "Texture Fetching").

#include <map>
#include <vector>

#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

struct Texture {
    std::vector<s16> voxels;
    int size[3];

    /// Returns the value in [-1, 1] at unnormalised, clamped coordinates. Fractions are rounded to 256ths, where the
    /// guide leaves open whether they are rounded or cut.
    f32 linear(f32 x, f32 y, f32 z) const;
};

/// Texture objects by their handles, from 1.
class Textures {
  public:
    u64 add(const Texture* texture) {
        all_[++last_] = texture;
        return last_;
    }
    /// Returns null where there is none.
    const Texture* find(u64 handle) const {
        const auto found = all_.find(handle);
        return found != all_.end() ? found->second : nullptr;
    }
    bool erase(u64 handle) { return all_.erase(handle) > 0; }
    bool shows(const Texture* texture) const {
        for (const auto& [handle, one] : all_)
            if (one == texture)
                return true;
        return false;
    }

  private:
    u64 last_ = 0;
    std::map<u64, const Texture*> all_;
};

}  // namespace pdr::ptx
