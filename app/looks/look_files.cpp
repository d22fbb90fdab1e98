#include "app/looks/look_files.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <string_view>

#include "render/base/file_ending.h"
#include "render/base/plain_file.h"
#include "render/scene/slicer/vp_json.h"
#include "render/scene/slicer/vp_text.h"

namespace pdr::app {
namespace {

constexpr std::uint64_t kMostBytes = 16 << 20;

/// Returns the file name without its extensions.
std::string plainName(const QString& path) {
    QString name = QFileInfo(path).fileName();
    for (const char* ending : {".json", ".vp"})
        if (name.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            name.chop(int(qstrlen(ending)));
    return name.isEmpty() ? "Slicer" : name.toStdString();
}

Result<NamedLook> fromSlicer(const Result<slicer::VolumeProperty>& property, const QString& path,
                             const NamedLook& base) {
    if (!property)
        return property.error();
    auto look = slicer::lookOf(*property, plainName(path), base);
    return look ? look : Result<NamedLook>(look.error().in(path.toStdString()));
}

}  // namespace

bool isLookFile(const QString& name) {
    const std::string ending = fileEnding(name.toStdString());
    return ending == ".json" || ending == ".vp";
}

Result<NamedLook> readLookFile(const QString& path, const NamedLook& base) {
    const std::string where = path.toStdString();
    const Result<std::string> bytes = readPlainFile(QFile::encodeName(path).toStdString(), kMostBytes);
    if (!bytes)
        return bytes.error();
    const std::string_view text = *bytes;
    if (path.endsWith(".vp.json", Qt::CaseInsensitive))
        return fromSlicer(slicer::propertyFromJson(text, where), path, base);
    if (path.endsWith(".vp", Qt::CaseInsensitive))
        return fromSlicer(slicer::propertyFromText(text, where), path, base);
    return lookFromJson(text, where);
}

Result<void> writeLookFile(const NamedLook& look, const QString& path) {
    const std::string text = path.endsWith(".vp.json", Qt::CaseInsensitive) ? slicer::jsonOf(slicer::propertyOf(look))
                             : path.endsWith(".vp", Qt::CaseInsensitive)    ? slicer::textOf(slicer::propertyOf(look))
                                                                            : lookText(look);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text.data(), qint64(text.size())) != qint64(text.size()) ||
        !file.commit())
        return Error{phrase("this look cannot be written: %1", file.errorString().toStdString()), path.toStdString(),
                     phrase("Choose another place.")};
    return {};
}

}  // namespace pdr::app
