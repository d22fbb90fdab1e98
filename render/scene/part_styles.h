#pragma once
/// How a look shows the parts of a label map, by their names: the parts themselves belong to a scan.

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "render/base/portable.h"
#include "render/scene/model.h"
#include "render/scene/parts.h"
#include "render/scene/transfer_function.h"

namespace pdr {

struct Scene;

enum class PartState {
    shown,
    ghost,  ///< with at most kGhostPerMm of extinction, so that one sees through a body
    hidden
};

/// Most extinction of a ghost [1/mm].
inline constexpr float kGhostPerMm = 0.01f;

/// How the parts of one name are shown.
struct PartStyle {
    std::string part;  ///< the name
    PartState state = PartState::shown;
    std::optional<vec3> colour;                        ///< albedo in place of the curve's, linear Rec. 709; [0, 1]
    std::optional<TransferFunction> transferFunction;  ///< none: that of the look
    std::string look;                                  ///< name of the look that has that curve; empty: none
    bool operator==(const PartStyle&) const = default;
};

struct PartStyles {
    PartState rest = PartState::shown;  ///< how all that is in no part is shown
    bool inColour = false;              ///< parts without a colour have that of the label map
    std::vector<PartStyle> styles;      ///< each name once; other parts are shown as the look shows all tissue

    bool empty() const { return *this == PartStyles{}; }
    bool operator==(const PartStyles&) const = default;
};

/// Checks names and curves; `where` of an error begins with "parts".
Result<void> check(const PartStyles& styles);

/// Returns how the parts of that name are shown.
PartStyle styleOf(const PartStyles& styles, const std::string& part);
/// Returns `styles` with that style in place of the one of the same part, which is left out where it says nothing.
PartStyles withStyle(PartStyles styles, PartStyle style);

/// Returns whether images of that model show the curves of parts: absorption and the scattering ones do.
bool showsParts(Model model);

/// Returns `scene`, which has the look's own curve, with the parts of `map` in their styles, and the rest in its. The
/// same scene where `map` is null, where its model shows no parts, or where all have the common curve.
Scene withParts(Scene scene, std::shared_ptr<const LabelMap> map, const PartStyles& styles);

}  // namespace pdr
