#include "render/scene/preset.h"

#include <utility>

#include "render/scene/field_reader.h"
#include "render/scene/field_writer.h"
#include "render/scene/fields/look_fields.h"

namespace pdr {

namespace {

constexpr std::string_view kFormat = "pdrender-preset";

}  // namespace

Result<Preset> presetFromJson(std::string_view json, std::string_view where) {
    Preset preset;
    const auto read = [&](JsonFields& fields) {
        FieldReader reader(fields);
        describe(reader, preset);
        if (auto ok = check(preset.look); !ok)
            throw FieldError{ok.error()};
    };
    if (auto ok = readJson(json, where, kFormat, read); !ok)
        return ok.error();
    return preset;
}

std::string presetText(Preset preset) {
    return jsonText(kFormat, FieldWriter::written(preset));
}

Scene withPreset(Scene scene, const Preset& preset) {
    scene = withLook(std::move(scene), preset.look);
    scene.lookName = preset.name;
    return scene;
}

}  // namespace pdr
