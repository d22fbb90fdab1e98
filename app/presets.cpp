#include "app/presets.h"

#include <QFile>

#include <string_view>

/// Qt's macro must stand outside of any namespace; without it the linker drops the resources of a static library.
static void keepResources() {
    Q_INIT_RESOURCE(resources);
}

namespace pdr::app {

Result<Preset> readPresetFile(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Error{"this preset cannot be read: " + file.errorString().toStdString(), path.toStdString(),
                     "Check the name and the permissions."};
    const QByteArray json = file.readAll();
    return presetFromJson({json.constData(), std::size_t(json.size())}, path.toStdString());
}

Result<std::vector<Preset>> bundledPresets() {
    keepResources();
    std::vector<Preset> presets;
    for (const char* name : {"ct_bone", "ct_soft_tissue", "ct_angio", "ct_lung"}) {
        Result<Preset> preset = readPresetFile(QStringLiteral(":/presets/%1.json").arg(QLatin1String(name)));
        if (!preset)
            return preset.error();
        presets.push_back(*std::move(preset));
    }
    return presets;
}

}  // namespace pdr::app
