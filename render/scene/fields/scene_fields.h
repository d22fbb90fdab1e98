#pragma once
/// Names, ranges and meanings of the fields of scene files.

#include "render/scene/fields/camera_fields.h"
#include "render/scene/fields/clip_fields.h"
#include "render/scene/fields/tissue_fields.h"
#include "render/scene/fields/visible_fields.h"
#include "render/scene/scene.h"

namespace pdr {

inline constexpr Words<Model, 6> kModelWords{{{"absorption", Model::absorption},
                                              {"emission", Model::emission},
                                              {"emissionAbsorption", Model::emissionAbsorption},
                                              {"singleScattering", Model::singleScattering},
                                              {"multipleScattering", Model::multipleScattering},
                                              {"maximumIntensity", Model::maximumIntensity}}};
inline constexpr Words<Estimator, 2> kEstimatorWords{
    {{"unbiased", Estimator::unbiased}, {"kroesMarch", Estimator::kroesMarch}}};
inline constexpr Words<Schedule::Kind, 2> kScheduleWords{
    {{"pd", Schedule::Kind::pd}, {"kroes", Schedule::Kind::kroes}}};

template <class Visit>
void describe(Visit& visit, Schedule& schedule) {
    visit.word({"kind",
                "`pd`: iterations are added up as they are made, then shown; or `kroes`: Exposure Render's order of "
                "work, there to be compared with; images say so"},
               schedule.kind, kScheduleWords);
    visit({"redundant", "`kroes` only: all is uploaded and allocated anew for each iteration, as there (K0); else K1"},
          schedule.redundant);
    visit({"filter", "`kroes` only: each iteration is blurred before it is added. It is biased"}, schedule.filter);
    visit({"runningMean",
           "`kroes` only: iterations are averaged as there; else summed as in `pd`, bit by bit where `filter` is off"},
          schedule.runningMean);
}

inline constexpr Words<Filtering, 2> kFilteringWords{{{"exact", Filtering::exact}, {"fast", Filtering::fast}}};

/// Describes a Scene's own fields except the lights, which files list together with the environment.
template <class Visit>
void describe(Visit& visit, Scene& scene) {
    PhaseField phase{scene.phaseG};
    SurfaceField surface{scene.gradientFactor, scene.rayOrigin};
    FilmField film{scene.film};
    visit.object({"transferFunction", "how Hounsfield units become optics", {}, kRequired}, scene.transferFunction);
    visit.word({"model", "optical model"}, scene.model, kModelWords);
    visit.word({"estimator",
                "`unbiased`, or `kroesMarch`: as Exposure Render takes its samples, in steps of 3 voxels, with one "
                "event and one light. It is biased and there to be compared with; only with `singleScattering`; "
                "images say `kroesMarch (biased)`"},
               scene.estimator, kEstimatorWords);
    visit.object({"schedule", "how iterations become displayed frames"}, scene.schedule);
    visit.word({"filtering",
                "how the scattering models read the volume between its voxels: `exact`, or `fast`, which leaves it to "
                "a GPU's texture units. They know 256 steps from voxel to voxel: a value may be off by 3/512 of the "
                "range of the eight voxels around it (24 HU between air and dense bone; 0.14 HU rms in the example "
                "head). The CPU, the models without scattering, and volumes that hold -32768 HU are always exact; "
                "`pdrender-bench filtering SCENE.json` says what it costs a scene"},
               scene.filtering, kFilteringWords);
    visit.object({"window", "what `maximumIntensity` shows black and white"}, scene.window);
    visit({"toleranceLevels",
           "largest error of a ray of the models without scattering [display levels of 255]",
           {1e-3, 16}},
          scene.toleranceLevels);
    visit.object({"phase", "how tissue scatters"}, phase);
    visit.object({"surface", "how readily an edge reflects like a surface"}, surface);
    visit({"background",
           "colour: radiance that the camera sees behind the volume instead of the environment; it lights nothing",
           kRadiance},
          scene.background);
    visit.object({"camera", "from where it is seen", {}, kRequired}, scene.camera);
    visit.object({"clip", "what is cut away"}, scene.clip);
    visit.object({"visible", "which part of the patient is shown"}, scene.visible);
    visit({"ctDenoised", "whether the CT is shown with less noise than it has; images say so"}, scene.ctDenoised);
    visit.object({"film", "the size of the image"}, film);
    visit({"maxBounces",
           "`multipleScattering`: events on a path, at most; paths that are cut there are counted and reported",
           {1, 100000}},
          scene.maxBounces);
    visit({"seed", "of the random numbers; another seed gives other noise"}, scene.seed);
}

}  // namespace pdr
