#include "render/scene/scene_file.h"

#include <fstream>
#include <iterator>
#include <utility>

#include "render/scene/look_fields.h"
#include "render/scene/range.h"
#include "render/volume/clamp.h"

namespace pdr {
namespace {

constexpr std::uintmax_t kLargestFile = 16u << 20;  ///< a scene is text; what is larger is something else

void orFail(const Result<void>& ok, const JsonFields& fields) {
    if (!ok)
        throw FieldError{below(fields.path(), ok.error())};
}

// ---- volume

void readRaw(JsonFields& fields, const std::filesystem::path& folder, RawFile& raw) {
    std::string path;
    fields.required("raw", path);
    raw.path = folder / path;
    fields.required("size", raw.size);
    fields.required("spacingMm", raw.spacingMm);
    fields.optional("type", raw.type,
                    {{"int16", RawFile::Type::int16},
                     {"uint16", RawFile::Type::uint16},
                     {"uint8", RawFile::Type::uint8},
                     {"float32", RawFile::Type::float32}});
    if (fields.has("originMm"))
        fields.required("originMm", raw.originMm.emplace());
    orFail(checkRange(dvec3(raw.size), {1, 65536}, "size"), fields);
    orFail(checkRange(raw.spacingMm, {kLowestSpacingMm, kHighestSpacingMm}, "spacingMm"), fields);
    orFail(checkRange(raw.originMm.value_or(dvec3(0)), {-1e9, 1e9}, "originMm"), fields);
}

VolumeSource readVolume(JsonFields fields, const std::filesystem::path& folder) {
    VolumeSource source;
    if (fields.has("dicom") == fields.has("raw"))
        fields.fail("dicom", "needs either a DICOM folder (dicom) or a raw file (raw)");
    if (fields.has("raw")) {
        readRaw(fields, folder, source.raw);
    } else {
        std::string path;
        fields.required("dicom", path);
        source.dicomFolder = folder / path;
        fields.optional("series", source.seriesUid);
    }
    if (fields.has("clampHu")) {
        auto& [lowest, highest] = source.clampHu.emplace();
        fields.required("clampHu", *source.clampHu);
        orFail(checkRange(dvec3(lowest, highest, lowest), {-32768, 32767}, "clampHu"), fields);
        if (lowest > highest)
            fields.fail("clampHu", "must begin with the lower value");
    }
    fields.finish();
    return source;
}

// ---- lights

Light readDirectional(JsonFields& fields) {
    DirectionalLight light;
    fields.required("direction", light.direction);
    fields.required("irradiance", light.irradiance);
    return light;
}

Light readRectangle(JsonFields& fields) {
    RectangleLight light;
    fields.required("centreMm", light.centreMm);
    fields.required("normal", light.normal);
    fields.required("up", light.up);
    fields.required("widthMm", light.widthMm);
    fields.required("heightMm", light.heightMm);
    fields.required("radiance", light.radiance);
    fields.optional("visible", light.visible);
    return light;
}

Light readSphere(JsonFields& fields) {
    SphereLight light;
    fields.required("centreMm", light.centreMm);
    fields.required("radiusMm", light.radiusMm);
    fields.required("radiance", light.radiance);
    fields.optional("visible", light.visible);
    return light;
}

Environment readEnvironment(JsonFields& fields, const std::filesystem::path& folder, SceneFile& file) {
    Environment environment;
    if (fields.has("image")) {
        std::string path;
        fields.required("image", path);
        file.environmentImage = folder / path;
        file.environmentField = fields.pathOf("image");
        environment.radiance = vec3(1);
        fields.optional("radiance", environment.radiance);
        fields.optional("rotationDegrees", environment.rotationDegrees);
    } else {
        fields.required("radiance", environment.radiance);
        if (fields.has("nadir"))
            fields.required("nadir", environment.nadir.emplace());
    }
    fields.optional("visible", environment.visible);
    return environment;
}

void readLights(JsonFields& parent, const std::filesystem::path& folder, SceneFile& file) {
    Scene& scene = file.scene;
    enum class Kind { directional, rectangle, sphere, environment };
    bool environmentSeen = false;
    for (JsonFields& fields : parent.objects("lights")) {
        Kind kind{};
        fields.required("type", kind,
                        {{"directional", Kind::directional},
                         {"rectangle", Kind::rectangle},
                         {"sphere", Kind::sphere},
                         {"environment", Kind::environment}});
        if (kind == Kind::environment) {
            if (std::exchange(environmentSeen, true))
                fields.fail("type", "is the second environment, a scene has at most one");
            scene.environment = readEnvironment(fields, folder, file);
            orFail(check(scene.environment), fields);
        } else {
            scene.lights.push_back(kind == Kind::directional ? readDirectional(fields)
                                   : kind == Kind::rectangle ? readRectangle(fields)
                                                             : readSphere(fields));
            orFail(check(scene.lights.back()), fields);
        }
        fields.finish();
    }
}

// ---- what is cut away

Clip readClip(JsonFields fields) {
    Clip clip;
    if (fields.has("box")) {
        JsonFields box = fields.object("box");
        ClipBox& corners = clip.box.emplace();
        box.required("lowMm", corners.lowMm);
        box.required("highMm", corners.highMm);
        box.finish();
    }
    if (fields.has("planes"))
        for (JsonFields& plane : fields.objects("planes")) {
            ClipPlane& added = clip.planes.emplace_back();
            plane.required("pointMm", added.pointMm);
            plane.required("normal", added.normal);
            plane.finish();
        }
    fields.optional("shadows", clip.shadows);
    fields.finish();
    return clip;
}

// ---- camera and film

Camera readCamera(JsonFields fields) {
    Camera camera;
    fields.optional("type", camera.type,
                    {{"perspective", Camera::Type::perspective}, {"orthographic", Camera::Type::orthographic}});
    fields.required("eyeMm", camera.eyeMm);
    fields.required("targetMm", camera.targetMm);
    fields.optional("up", camera.up);
    if (camera.type == Camera::Type::perspective)
        fields.optional("fovDegrees", camera.fovDegrees);
    else
        fields.required("heightMm", camera.heightMm);
    fields.optional("apertureMm", camera.apertureMm);
    fields.optional("focusMm", camera.focusMm);
    fields.finish();
    return camera;
}

ivec2 readFilm(JsonFields fields) {
    ivec2 size(0);
    fields.required("width", size.x);
    fields.required("height", size.y);
    fields.finish();
    return size;
}

void readModel(JsonFields& fields, Model& model) {
    const auto word = [](Model meant) { return std::pair<std::string_view, Model>(modelName(meant), meant); };
    fields.optional("model", model,
                    {word(Model::absorption), word(Model::emission), word(Model::emissionAbsorption),
                     word(Model::singleScattering), word(Model::multipleScattering), word(Model::maximumIntensity)});
}

void readEstimator(JsonFields& fields, Estimator& estimator) {
    const auto word = [](Estimator meant) {
        return std::pair<std::string_view, Estimator>(estimatorName(meant), meant);
    };
    fields.optional("estimator", estimator, {word(Estimator::unbiased), word(Estimator::kroesMarch)});
}

void readFiltering(JsonFields& fields, Filtering& filtering) {
    const auto word = [](Filtering meant) {
        return std::pair<std::string_view, Filtering>(filteringName(meant), meant);
    };
    fields.optional("filtering", filtering, {word(Filtering::exact), word(Filtering::fast)});
}

void readScene(JsonFields& fields, const std::filesystem::path& folder, SceneFile& file) {
    Scene& scene = file.scene;
    file.source = readVolume(fields.object("volume"), folder);
    scene.transferFunction = readTransferFunction(fields);
    readModel(fields, scene.model);
    readEstimator(fields, scene.estimator);
    readFiltering(fields, scene.filtering);
    readWindow(fields, scene.window);
    fields.optional("toleranceLevels", scene.toleranceLevels);
    readPhase(fields, scene.phaseG);
    readSurface(fields, scene.gradientFactor);
    if (fields.has("lights"))
        readLights(fields, folder, file);
    scene.camera = readCamera(fields.object("camera"));
    if (fields.has("clip"))
        scene.clip = readClip(fields.object("clip"));
    if (fields.has("film"))
        scene.film = readFilm(fields.object("film"));
    fields.optional("maxBounces", scene.maxBounces);
    fields.optional("seed", scene.seed);
    orFail(scene.check(), fields);
}

Result<std::string> readText(const std::filesystem::path& path) {
    std::error_code failure;
    const std::uintmax_t size = std::filesystem::file_size(path, failure);
    if (failure)
        return Error{"the scene file cannot be read (" + failure.message() + ")", path.string(), "Check the path."};
    if (size > kLargestFile)
        return Error{"is too large for a scene file", path.string(), "Scene files are JSON texts of a few kilobytes."};
    std::ifstream stream(path, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), {}};
    if (!stream && !stream.eof())
        return Error{"the scene file cannot be read", path.string(), "Check that you may read it."};
    return text;
}

}  // namespace

Result<SceneFile> readSceneFile(const std::filesystem::path& path) {
    const Result<std::string> text = readText(path);
    if (!text)
        return text.error();
    SceneFile file;
    const auto read = [&](JsonFields& fields) { readScene(fields, path.parent_path(), file); };
    if (auto ok = readJson(*text, path.string(), "pdrender-scene", read); !ok)
        return ok.error();
    return file;
}

Result<std::shared_ptr<const Volume>> fetchRawVolume(const VolumeSource& source) {
    Result<Volume> volume = loadRaw(source.raw);
    if (!volume) {
        Error error = volume.error();
        error.where += " (volume.raw)";
        return error;
    }
    return std::make_shared<const Volume>(clamped(*std::move(volume), source.clampHu));
}

}  // namespace pdr
