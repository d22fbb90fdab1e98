#pragma once
/// Names, ranges and meanings of the fields of tissue.

#include "render/scene/fields/ranges.h"
#include "render/scene/scene.h"

namespace pdr {

template <class Visit>
void describe(Visit& visit, TransferNode& node) {
    visit({"hu", "Hounsfield units", kHounsfield, kRequired}, node.hu);
    visit({"opacity", "fraction of `extinctionPerMm`", kFraction, kRequired}, node.opacity);
    visit({"albedo", "colour: the scattered fraction of what is extinguished", kFraction}, node.albedo);
    visit({"emission",
           "colour: radiance given off per optical depth; emission coefficient = `emission` x extinction",
           {0, 1e6}},
          node.emission);
    visit({"specular", "colour: reflectance of a surface seen straight on", kFraction}, node.specular);
    visit({"roughness", "of that surface; 0 mirror, 1 dull", kFraction}, node.roughness);
}

template <class Visit>
void describe(Visit& visit, TransferFunction& function) {
    visit({"extinctionPerMm",
           "extinction where the opacity is 1 [1/mm]; extinction = `extinctionPerMm` x `opacity`. `multipleScattering` "
           "stands 1000 free paths between voxels (extinction x largest spacing); beyond, programs and images warn "
           "(`overDense`)",
           {0, 1e6},
           kRequired},
          function.extinctionPerMm);
    visit.list({"nodes", "a list of 1 to 4096, ascending in `hu`", {}, kRequired}, function.nodes);
}

template <class Visit>
void describe(Visit& visit, HuWindow& window) {
    visit({"lowHu", "shown black [HU]", kHounsfield, kRequired}, window.lowHu);
    visit({"highHu", "shown white [HU]; above `lowHu`", kHounsfield, kRequired}, window.highHu);
}

/// The scattering and the surface reflection of tissue: two objects in files, two numbers here.
struct PhaseField {
    float& g;
};
template <class Visit>
void describe(Visit& visit, PhaseField& phase) {
    visit({"g",
           "mean cosine of the scattering angle (Henyey-Greenstein); 0 = to all sides alike, positive = onward",
           {-1, 1, false, false}},
          phase.g);
}
inline constexpr Words<RayOrigin, 2> kRayOriginWords{
    {{"event", RayOrigin::event}, {"outsideEdge", RayOrigin::outsideEdge}}};
struct SurfaceField {
    float& gradientFactor;
    RayOrigin& rayOrigin;
};
template <class Visit>
void describe(Visit& visit, SurfaceField& surface) {
    visit({"gradientFactor",
           "how readily an event at an edge between tissues is a reflection instead of scattering; 0 = never",
           kGradientFactor},
          surface.gradientFactor);
    visit.word({"rayOrigin",
                "where rays to the light leave a surface: at the `event`, inside the surface's own soft edge, which "
                "shadows it in rings; or one voxel out, `outsideEdge`, where they lose what a plane edge takes on "
                "average: shadows narrower than one voxel are lost"},
               surface.rayOrigin, kRayOriginWords);
}

}  // namespace pdr
