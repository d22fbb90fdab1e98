#pragma once
/// What the fields of scene files, presets and sessions are called, which range they have, and what they mean.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/scene/field.h"
#include "render/scene/picture_setup.h"
#include "render/scene/scene.h"
#include "render/scene/scene_file.h"

namespace pdr {

inline constexpr Range kHounsfield{-32768, 32767};
inline constexpr Range kFraction{0, 1};
inline constexpr Range kRadiance{0, 1e30f};  // as float has it: a little more
inline constexpr Range kPlaceMm{-1e9, 1e9};
inline constexpr Range kExtentMm{0, 1e9, false};
inline constexpr double kLeastMm = 1e-12;  ///< less is nothing, and its square must not be

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
           "stands 1000 free paths between voxels (extinction x largest spacing); beyond, programs and pictures warn "
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

/// How tissue scatters, and how readily its edges reflect: two objects in files, two numbers here.
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
struct SurfaceField {
    float& gradientFactor;
};
template <class Visit>
void describe(Visit& visit, SurfaceField& surface) {
    visit({"gradientFactor",
           "how readily an event at an edge between tissues is a reflection instead of scattering; 0 = never",
           {0, 1e6}},
          surface.gradientFactor);
}

// ---- lights

template <class Visit>
void describe(Visit& visit, DirectionalLight& light) {
    visit.direction({"direction", "the way the light travels", {}, kRequired}, light.direction);
    visit({"irradiance", "colour: on a plane that faces the light", kRadiance, kRequired}, light.irradiance);
}

template <class Visit>
void describe(Visit& visit, RectangleLight& light) {
    visit({"centreMm", "its centre [mm]", kPlaceMm, kRequired}, light.centreMm);
    visit.direction({"normal", "the side it shines to", {}, kRequired}, light.normal);
    visit.direction({"up", "along its height; not along the normal", {}, kRequired}, light.up);
    visit({"widthMm", "[mm]", kExtentMm, kRequired}, light.widthMm);
    visit({"heightMm", "[mm]", kExtentMm, kRequired}, light.heightMm);
    visit({"radiance", "colour", kRadiance, kRequired}, light.radiance);
    visit({"visible", "whether the camera sees it, from its shining side"}, light.visible);
}

template <class Visit>
void describe(Visit& visit, SphereLight& light) {
    visit({"centreMm", "its centre [mm]", kPlaceMm, kRequired}, light.centreMm);
    visit({"radiusMm", "[mm]", kExtentMm, kRequired}, light.radiusMm);
    visit({"radiance", "colour", kRadiance, kRequired}, light.radiance);
    visit({"visible", "whether the camera sees it"}, light.visible);
}

/// The environment as files write it: its picture is a path there.
struct EnvironmentFields {
    Environment environment;
    std::optional<std::string> image;
};

template <class Visit>
void describe(Visit& visit, EnvironmentFields& fields) {
    Environment& environment = fields.environment;
    visit({"image",
           "an OpenEXR picture of the surroundings, latitude-longitude: its top row is towards the head, its middle at "
           "the back, its right half on the patient's left. Bright spots are aimed at"},
          fields.image);
    if (Visit::kReads && fields.image)
        environment.radiance = vec3(1);
    visit({"radiance",
           "colour; with `nadir`: what comes from straight above (towards the head); with `image`: what the picture is "
           "multiplied by, 1 where it is absent",
           kRadiance, !fields.image},
          environment.radiance);
    if (Visit::kBranches || !fields.image)
        visit({"nadir", "colour from straight below; in between it changes evenly with the height", kRadiance},
              environment.nadir);
    if (Visit::kBranches || fields.image)
        visit({"rotationDegrees", "turns the picture about the patient's axis, from the back towards the left"},
              environment.rotationDegrees);
    visit({"visible", "whether the camera sees it behind the volume; it lights the volume either way"},
          environment.visible);
}

/// An entry of the list `lights`.
using LightFields = std::variant<DirectionalLight, RectangleLight, SphereLight, EnvironmentFields>;

inline LightFields freshLight(std::size_t kind) {
    switch (kind) {
        case 0:
            return DirectionalLight{};
        case 1:
            return RectangleLight{};
        case 2:
            return SphereLight{};
        default:
            return EnvironmentFields{};
    }
}

inline constexpr Words<std::size_t, 4> kLightWords{
    {{"directional", 0}, {"rectangle", 1}, {"sphere", 2}, {"environment", 3}}};

template <class Visit>
void describe(Visit& visit, LightFields& light) {
    std::size_t kind = light.index();
    visit.word({"type", "what it is", {}, kRequired}, kind, kLightWords);
    if (kind != light.index())
        light = freshLight(kind);
    std::visit([&](auto& one) { describe(visit, one); }, light);
}

// ---- what is cut away

template <class Visit>
void describe(Visit& visit, ClipBox& box) {
    visit({"lowMm", "one corner [mm]", kPlaceMm, kRequired}, box.lowMm);
    visit({"highMm", "the corner across; above `lowMm` along every axis [mm]", kPlaceMm, kRequired}, box.highMm);
}

template <class Visit>
void describe(Visit& visit, ClipPlane& plane) {
    visit({"pointMm", "a point of the plane [mm]", kPlaceMm, kRequired}, plane.pointMm);
    visit.direction({"normal", "its normal", {}, kRequired}, plane.normal);
}

template <class Visit>
void describe(Visit& visit, Clip& clip) {
    visit.object({"box", "only what lies between these corners stays"}, clip.box);
    visit.list({"planes", "a list; all on the side of a plane's normal is cut away"}, clip.planes);
    visit({"shadows", "whether what is cut away still throws its shadow"}, clip.shadows);
}

// ---- camera and film

inline constexpr Words<Camera::Type, 2> kCameraWords{
    {{"perspective", Camera::Type::perspective}, {"orthographic", Camera::Type::orthographic}}};

template <class Visit>
void describe(Visit& visit, Camera& camera) {
    constexpr Range kEyeMm{-1e15, 1e15};
    visit.word({"type", ""}, camera.type, kCameraWords);
    visit({"eyeMm", "where it is [mm]", kEyeMm, kRequired}, camera.eyeMm);
    visit({"targetMm", "the point in the middle of the picture, at least 1e-12 from the eye [mm]", kEyeMm, kRequired},
          camera.targetMm);
    visit.direction({"up", "what is up in the picture; not along the view"}, camera.up);
    if (Visit::kBranches || camera.type == Camera::Type::perspective)
        visit({"fovDegrees", "perspective only: vertical field of view [degrees]", {kLeastMm, 180, true, false}},
              camera.fovDegrees);
    if (Visit::kBranches || camera.type == Camera::Type::orthographic)
        visit({"heightMm", "orthographic only: height of what is seen [mm]", {kLeastMm, 1e9}, kRequired},
              camera.heightMm);
    visit({"apertureMm", "diameter of the lens; 0 = a pinhole, all is sharp [mm]", {0, 200}}, camera.apertureMm);
    visit({"focusMm",
           "distance of the sharp plane from the eye, at least 1e-12; 0 = the target's [mm]",
           {camera.focusMm == 0 || Visit::kBranches ? 0 : kLeastMm, 1e9}},
          camera.focusMm);
}

struct FilmField {
    ivec2& size;
};
template <class Visit>
void describe(Visit& visit, FilmField& film) {
    visit({"width", "[pixels]", {1, 16384}, kRequired}, film.size.x);
    visit({"height", "[pixels]", {1, 16384}, kRequired}, film.size.y);
}

// ---- volume

inline constexpr Words<RawFile::Type, 4> kVoxelWords{{{"int16", RawFile::Type::int16},
                                                      {"uint16", RawFile::Type::uint16},
                                                      {"uint8", RawFile::Type::uint8},
                                                      {"float32", RawFile::Type::float32}}};
inline constexpr Words<Reconstruction, 2> kReconstructionWords{
    {{"linear", Reconstruction::linear}, {"cubic", Reconstruction::cubic}}};

/// Where the voxels come from, as files write it.
inline constexpr Words<Table, 2> kTableWords{{{"shown", Table::shown}, {"hidden", Table::hidden}}};

struct VolumeFields {
    std::optional<std::string> dicom, series, raw;
    RawFile file;  ///< its path is `raw`
    std::optional<std::pair<int, int>> clampHu;
    Table table = Table::shown;
    Reconstruction reconstruction = Reconstruction::linear;
};

template <class Visit>
void describe(Visit& visit, VolumeFields& volume) {
    visit({"dicom", "the folder of DICOM files"}, volume.dicom);
    visit({"raw", "or the raw file"}, volume.raw);
    if (Visit::kBranches || volume.dicom)
        visit({"series",
               "SeriesInstanceUID of the series to take, as `info` names it (`#2` behind it: its second "
               "part); where it is absent, the first that can be loaded"},
              volume.series);
    if (Visit::kBranches || volume.raw || !volume.dicom) {
        visit({"size", "voxels along x, y, z", {1, 65536}, kRequired}, volume.file.size);
        visit({"spacingMm", "distance of voxel centres [mm]", {kLowestSpacingMm, kHighestSpacingMm}, kRequired},
              volume.file.spacingMm);
        visit.word({"type", "of a voxel; float32 is rounded"}, volume.file.type, kVoxelWords);
        visit({"originMm",
               "centre of voxel (0, 0, 0); where it is absent, half a spacing, so that the box begins at 0 "
               "[mm]",
               kPlaceMm},
              volume.file.originMm);
    }
    visit({"clampHu", "`[lowest, highest]`: every voxel is clamped to this interval first [HU]", kHounsfield},
          volume.clampHu);
    visit.word(
        {"table",
         "`hidden`: all outside the patient's body is air, as far as it is known what is body: table, head holder, "
         "clothes. The voxels themselves stay as they are; pictures say how much is hidden. `pdrender-cli render "
         "--table` goes before it"},
        volume.table, kTableWords);
    visit.word(
        {"reconstruction",
         "what stands between the slices: `linear` goes evenly from one to the next, `cubic` first puts one more "
         "between each two, from the four around it. Steps of the slices are lower then, by half where slopes "
         "are gentle; it takes twice the memory, and pictures say `slices interpolated`"},
        volume.reconstruction, kReconstructionWords);
}

// ---- the scene

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
                "work, there to be compared with; pictures say so"},
               schedule.kind, kScheduleWords);
    visit({"redundant", "`kroes` only: all is uploaded and allocated anew for each iteration, as there (K0); else K1"},
          schedule.redundant);
    visit({"filter", "`kroes` only: each iteration is blurred before it is added. It is biased"}, schedule.filter);
    visit({"runningMean",
           "`kroes` only: iterations are averaged as there; else summed as in `pd`, bit by bit where `filter` is off"},
          schedule.runningMean);
}

inline constexpr Words<Filtering, 2> kFilteringWords{{{"exact", Filtering::exact}, {"fast", Filtering::fast}}};

/// A Scene's own fields, but for the lights, which files list together with the environment.
template <class Visit>
void describe(Visit& visit, Scene& scene) {
    PhaseField phase{scene.phaseG};
    SurfaceField surface{scene.gradientFactor};
    FilmField film{scene.film};
    visit.object({"transferFunction", "how Hounsfield units become optics", {}, kRequired}, scene.transferFunction);
    visit.word({"model", "optical model"}, scene.model, kModelWords);
    visit.word({"estimator",
                "`unbiased`, or `kroesMarch`: as Exposure Render takes its samples, in steps of 3 voxels, with one "
                "event and one light. It is biased and there to be compared with; only with `singleScattering`; "
                "pictures say `kroesMarch (biased)`"},
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
    visit.object({"camera", "from where it is seen", {}, kRequired}, scene.camera);
    visit.object({"clip", "what is cut away"}, scene.clip);
    visit.object({"film", "the size of the picture"}, film);
    visit({"maxBounces",
           "`multipleScattering`: events on a path, at most; paths that are cut there are counted and reported",
           {1, 100000}},
          scene.maxBounces);
    visit({"seed", "of the random numbers; another seed gives other noise"}, scene.seed);
}

// ---- looks: presets and sessions

inline constexpr Words<LightRig::Follows, 2> kFollowsWords{
    {{"camera", LightRig::Follows::camera}, {"patient", LightRig::Follows::patient}}};

/// The rig and what lights the rest.
struct RigFields {
    LightRig& rig;
    Environment& environment;
};
template <class Visit>
void describe(Visit& visit, RigFields& fields) {
    constexpr Range kScale{0, 1e6};
    visit({"key", "radiance scale of the main panel, upper left", kScale}, fields.rig.key);
    visit({"fill", "of the panel on the other side", kScale}, fields.rig.fill);
    visit({"rim", "of the panel behind", kScale}, fields.rig.rim);
    visit.word({"follows",
                "what the panels move with: the `camera`, so that each view is lit alike, or the `patient`, lit as in "
                "the view from the front"},
               fields.rig.follows, kFollowsWords);
    visit({"ambient", "colour: radiance of the environment; with `nadir`: from straight above (towards the head)",
           kScale},
          fields.environment.radiance);
    visit({"nadir", "colour from straight below; in between it changes evenly with the height", kScale},
          fields.environment.nadir);
    visit({"visible", "whether the camera sees the environment behind the volume"}, fields.environment.visible);
}

template <class Visit>
void describe(Visit& visit, Look& look) {
    PhaseField phase{look.phaseG};
    SurfaceField surface{look.gradientFactor};
    RigFields rig{look.rig, look.environment};
    visit.object({"transferFunction", "how Hounsfield units become optics", {}, kRequired}, look.transferFunction);
    visit.object({"window", "what `maximumIntensity` shows black and white"}, look.window);
    visit.object({"phase", "how tissue scatters"}, phase);
    visit.object({"surface", "how readily an edge reflects like a surface"}, surface);
    visit.object({"lights", "the rig of lights, and the environment"}, rig);
    visit({"exposure", "radiance that is shown as 1 - 1/e", {0, 1e30f, false}}, look.display.exposure);
}

template <class Visit>
void describe(Visit& visit, PictureSetup& setup) {
    visit.object({"look", "how tissue looks", {}, kRequired}, setup.look);
    visit({"lookName", "what the user calls it"}, setup.lookName);
    visit({"stops", "brightness against the look's; one more is twice as bright", {-64, 64}}, setup.stops);
    visit.object({"camera", "from where it is seen", {}, kRequired}, setup.camera);
    visit.object({"clip", "what is cut away"}, setup.clip);
    visit.word({"table", "whether the scanner's table and the head holder are seen"}, setup.table, kTableWords);
    visit.word({"model", "optical model"}, setup.model, kModelWords);
    visit.word({"estimator", "`unbiased`, or `kroesMarch`, as in scene files"}, setup.estimator, kEstimatorWords);
    visit.object({"schedule", "how iterations become displayed frames"}, setup.schedule);
}

}  // namespace pdr
