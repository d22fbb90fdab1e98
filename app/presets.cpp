#include "app/presets.h"

#include <QFile>

#include <string_view>

/// Qt's macro must stand outside of any namespace; without it the linker drops the resources of a static library.
static void keepResources() {
    Q_INIT_RESOURCE(resources);
}

namespace pdr::app {

Result<std::vector<Preset>> bundledPresets() {
    keepResources();
    std::vector<Preset> presets;
    for (const char* name : {"ct_bone", "ct_soft_tissue", "ct_angio", "ct_lung"}) {
        const QString path = QStringLiteral(":/presets/%1.json").arg(QLatin1String(name));
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return Error{"this preset is missing from the program", path.toStdString(), "Install the program again."};
        const QByteArray json = file.readAll();
        Result<Preset> preset = presetFromJson({json.constData(), std::size_t(json.size())}, path.toStdString());
        if (!preset)
            return preset.error();
        presets.push_back(*std::move(preset));
    }
    return presets;
}

}  // namespace pdr::app
