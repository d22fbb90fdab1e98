#include "app/looks/looks.h"

#include <QFile>

#include "render/scene/named_look.h"

/// Keeps the resources of this static library, which the linker would drop. Qt's macro must stand outside of any
/// namespace.
static void keepResources() {
    Q_INIT_RESOURCE(resources);
}

namespace pdr::app {
namespace {

constexpr const char* kNames[] = {"bone",
                                  "bones_alone",
                                  "bone_beside_contrast",
                                  "thin_bone",
                                  "muscles_and_skull",
                                  "skull_and_mirror",
                                  "heart",
                                  "muscles",
                                  "organs",
                                  "organs_in_colour",
                                  "vessels",
                                  "vessels_and_bone",
                                  "bones_and_vessels",
                                  "bones_vessels_and_muscle",
                                  "vessels_in_ghost",
                                  "lung_vessels",
                                  "mip_lungs",
                                  "mip",
                                  "xray",
                                  "fluoroscopy",
                                  "implants",
                                  "implant_over_ghost",
                                  "skin_and_bone",
                                  "skin"};

}  // namespace

Result<std::vector<NamedLook>> bundledLooks() {
    keepResources();
    std::vector<NamedLook> looks;
    for (const char* name : kNames) {
        QFile file(QStringLiteral(":/looks/%1.json").arg(QLatin1String(name)));
        const std::string text = file.open(QFile::ReadOnly) ? file.readAll().toStdString() : std::string();
        Result<NamedLook> look = lookFromJson(text, file.fileName().toStdString());
        if (!look)
            return look.error();
        looks.push_back(*std::move(look));
    }
    return looks;
}

bool followsTissue(Model model) {
    return model != Model::absorption && model != Model::maximumIntensity;
}

}  // namespace pdr::app
