#include "render/scene/environment_image.h"

#include <string>

#include "render/base/image_size.h"
#include "render/scene/range.h"

namespace pdr {

Result<void> EnvironmentImage::check() const {
    constexpr Range kSide{1, kLongestSide};
    for (const auto& ok : {checkRange(size.x, kSide, "width"), checkRange(size.y, kSide, "height")})
        if (!ok)
            return ok;
    if (texels.size() != std::size_t(size.x) * size.y)
        return Error{phrase("the environment image is not complete"), "", ""};
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const std::string where = "texel (" + std::to_string(i % size.x) + ", " + std::to_string(i / size.x) + ")";
        if (auto ok = checkRange(dvec3(texels[i]), {0, 1e30f}, where); !ok)
            return ok;
    }
    return {};
}

}  // namespace pdr
