#include "render/scene/scene_file.h"

#include <iterator>
#include <string>
#include <type_traits>
#include <utility>

#include "render/base/plain_file.h"
#include "render/scene/field_check.h"
#include "render/scene/field_reader.h"
#include "render/scene/field_writer.h"
#include "render/scene/fields/light_fields.h"
#include "render/scene/fields/parts_fields.h"
#include "render/scene/fields/scene_fields.h"
#include "render/scene/fields/volume_fields.h"
#include "render/volume/clamp.h"

namespace pdr {
namespace {

constexpr std::string_view kFormat = "pdrender-scene";
constexpr std::uint64_t kLargestFile = 16u << 20;  ///< a scene is text; a larger file is something else

[[noreturn]] void fail(const std::string& field, const Text& what) {
    throw FieldError{{what, field, ""}};
}

void orFail(const Result<void>& checked) {
    if (!checked)
        throw FieldError{checked.error()};
}

// ---- from the file's fields to values, and back

VolumeSource sourceOf(const VolumeFields& fields, const std::filesystem::path& folder) {
    VolumeSource source;
    if (fields.dicom.has_value() == fields.raw.has_value())
        fail("volume.dicom", phrase("needs either a DICOM folder (dicom) or a raw file (raw)"));
    orFail(FieldCheck::check(fields, "volume"));
    if (fields.raw) {
        source.raw = fields.file;
        source.raw.path = folder / *fields.raw;
    } else {
        source.dicomFolder = folder / *fields.dicom;
        source.seriesUid = fields.series.value_or("");
    }
    source.clampHu = fields.clampHu;
    source.table = fields.table;
    source.reconstruction = fields.reconstruction;
    if (source.clampHu && source.clampHu->first > source.clampHu->second)
        fail("volume.clampHu", phrase("must begin with the lower value"));
    return source;
}

VolumeFields fieldsOf(const VolumeSource& source) {
    VolumeFields fields;
    if (!source.raw.path.empty()) {
        fields.raw = source.raw.path.string();
        fields.file = source.raw;
    } else {
        fields.dicom = source.dicomFolder.string();
        if (!source.seriesUid.empty())
            fields.series = source.seriesUid;
    }
    fields.clampHu = source.clampHu;
    fields.table = source.table;
    fields.reconstruction = source.reconstruction;
    return fields;
}

/// Stores where the parts come from and their materials.
void takeParts(const PartsFields& fields, const std::filesystem::path& folder, SceneFile& file) {
    if (fields.labels.has_value() == fields.find.has_value())
        fail("parts.labels", phrase("needs either a label map (labels) or a rule that finds parts (find)"));
    orFail(FieldCheck::check(fields, "parts"));
    if (fields.labels)
        file.parts.labels = folder / *fields.labels;
    if (fields.find) {
        Result<segment::PartRules> rules = segment::partRulesFrom(*fields.find);
        if (!rules)
            fail("parts.find", rules.error().what);
        file.parts.rules = *std::move(rules);
    }
    file.parts.resampling = fields.resample ? Resampling::nearest : Resampling::refused;
    for (const PartMaterialFields& one : fields.materials)
        file.scene.parts.curves.push_back({std::uint8_t(one.label), one.transferFunction, one.gradientFactor});
}

std::optional<PartsFields> fieldsOf(const PartsSource& source, const std::vector<PartCurve>& curves) {
    if (!source.isGiven())
        return {};
    PartsFields fields;
    if (!source.labels.empty())
        fields.labels = source.labels.string();
    if (source.finds())
        fields.find = segment::partRulesText(source.rules);
    fields.resample = source.resampling == Resampling::nearest;
    for (const PartCurve& curve : curves)
        fields.materials.push_back({curve.label, curve.transferFunction, curve.gradientFactor});
    return fields;
}

void takeLights(const std::vector<LightFields>& entries, const std::filesystem::path& folder, SceneFile& file) {
    bool environmentSeen = false;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string where = "lights[" + std::to_string(i) + "]";
        if (const auto* around = std::get_if<EnvironmentFields>(&entries[i])) {
            if (std::exchange(environmentSeen, true))
                fail(where + ".type", phrase("is the second environment, a scene has at most one"));
            file.scene.environment = around->environment;
            if (around->image) {
                file.environmentImage = folder / *around->image;
                file.environmentField = where + ".image";
            }
            if (const Result<void> checked = check(around->environment); !checked)
                orFail(below(where, checked.error()));
            continue;
        }
        std::visit(
            [&](const auto& light) {
                if constexpr (std::is_constructible_v<Light, decltype(light)>)
                    file.scene.lights.push_back(light);
            },
            entries[i]);
        if (const Result<void> checked = check(file.scene.lights.back()); !checked)
            orFail(below(where, checked.error()));
    }
}

std::vector<LightFields> lightFieldsOf(const SceneFile& file) {
    std::vector<LightFields> entries;
    for (const Light& light : file.scene.lights)
        std::visit([&](const auto& one) { entries.emplace_back(one); }, light);
    EnvironmentFields around{file.scene.environment, {}};
    if (!file.environmentImage.empty())
        around.image = file.environmentImage.string();
    if (around.image || around.environment != Environment{})
        entries.emplace_back(around);
    return entries;
}

/// The fields of a scene file, as they stand in it.
struct FileFields {
    VolumeFields volume;
    std::vector<LightFields> lights;
    std::optional<PartsFields> parts;
    Scene scene;
};
template <class Visit>
void describe(Visit& visit, FileFields& file) {
    visit.object({"volume", "where the voxels come from", {}, kRequired}, file.volume);
    visit.list({"lights", "a list; without any the image is black"}, file.lights);
    visit.object({"parts", "parts of the patient with materials of their own"}, file.parts);
    describe(visit, file.scene);
}

void readScene(JsonFields& fields, const std::filesystem::path& folder, SceneFile& file) {
    FileFields read;
    FieldReader reader(fields);
    describe(reader, read);
    file.scene = std::move(read.scene);
    file.source = sourceOf(read.volume, folder);
    takeLights(read.lights, folder, file);
    if (read.parts)
        takeParts(*read.parts, folder, file);
    orFail(file.scene.check());
}

}  // namespace

Result<SceneFile> sceneFromText(std::string_view text, const std::string& where, const std::filesystem::path& folder) {
    SceneFile file;
    const auto read = [&](JsonFields& fields) { readScene(fields, folder, file); };
    if (auto ok = readJson(text, where, kFormat, read); !ok)
        return ok.error();
    return file;
}

Result<SceneFile> readSceneFile(const std::filesystem::path& path) {
    const Result<std::string> text = readPlainFile(path, kLargestFile);
    if (!text)
        return text.error();
    return sceneFromText(*text, path.string(), path.parent_path());
}

std::string sceneText(const SceneFile& file) {
    FileFields fields{fieldsOf(file.source), lightFieldsOf(file), fieldsOf(file.parts, file.scene.parts.curves),
                      file.scene};
    return jsonText(kFormat, FieldWriter::written(fields));
}

std::string cameraText(const Camera& camera) {
    Camera written = camera;
    return FieldWriter::written(written).dump();
}

Result<WantedVolume> asWanted(Volume volume, const VolumeSource& source, const Progress& progress) {
    const auto scan = std::make_shared<const Volume>(clamped(std::move(volume), source.clampHu));
    WantedVolume wanted{scan, {scan->geometry(), nullptr}, scan, {}};
    if (source.table == Table::hidden) {
        auto table = segment::hideTable(*scan, progress);
        if (!table)
            return table.error();
        wanted.table = *std::move(table);
        wanted.volume = wanted.table.body ? wanted.table.body : scan;
        wanted.framed = {wanted.table.bodyBox, wanted.table.outlineMm};
    }
    if (source.reconstruction != Reconstruction::linear)
        wanted.volume = std::make_shared<const Volume>(reconstructed(Volume(*wanted.volume), source.reconstruction));
    return wanted;
}

Result<WantedVolume> fetchRawVolume(const VolumeSource& source, const Progress& progress) {
    Result<Volume> volume = loadRaw(source.raw);
    if (!volume) {
        Error error = volume.error();
        error.where += " (volume.raw)";
        return error;
    }
    return asWanted(*std::move(volume), source, progress);
}

}  // namespace pdr
