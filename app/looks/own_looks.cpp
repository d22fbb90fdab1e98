#include "app/looks/own_looks.h"

#include <QDir>
#include <QFile>
#include <QStandardPaths>
#include <QUrl>

#include "app/looks/look_files.h"

namespace pdr::app {
namespace {

/// Bytes of UTF-8. Percent encoding makes three of each in a file name, which may have 255.
constexpr std::size_t kLongestName = 60;

Result<void> checkName(const std::string& name) {
    if (QString::fromStdString(name).trimmed().isEmpty())
        return Error{phrase("a look needs a name"), "", ""};
    if (name.size() > kLongestName)
        return Error{phrase("this name is too long"), name, phrase("Choose a shorter name.")};
    return {};
}

}  // namespace

QString OwnLooks::usualFolder() {
    return QStandardPaths::writableLocation(QStandardPaths::AppConfigLocation) + "/looks";
}

/// Returns the file of a look. Percent encoding makes a valid file name of every name, on every system.
QString OwnLooks::fileOf(const std::string& name) const {
    return folder_ + "/" + QString::fromLatin1(QUrl::toPercentEncoding(QString::fromStdString(name), " ", ".~")) +
           ".json";
}

OwnLooks::Read OwnLooks::read() const {
    Read all;
    const QDir folder(folder_);
    for (const QString& name : folder.entryList({"*.json"}, QDir::Files, QDir::Name)) {
        auto look = readLookFile(folder.filePath(name));
        if (look) {
            look->group = LookGroup::own;
            all.looks.push_back(*std::move(look));
        } else {
            all.problems.push_back(look.error());
        }
    }
    return all;
}

Result<void> OwnLooks::save(NamedLook look) {
    if (auto ok = checkName(look.name); !ok)
        return ok;
    if (!QDir().mkpath(folder_))
        return Error{phrase("the folder for your looks cannot be made"), folder_.toStdString(),
                     phrase("Check its permissions.")};
    look.group = LookGroup::own;
    return writeLookFile(look, fileOf(look.name));
}

Result<void> OwnLooks::rename(const std::string& from, const std::string& to) {
    auto look = readLookFile(fileOf(from));
    if (!look)
        return look.error();
    look->name = to;
    if (auto ok = save(*look); !ok)
        return ok;
    return fileOf(from) == fileOf(to) ? Result<void>() : remove(from);
}

Result<void> OwnLooks::remove(const std::string& name) {
    QFile file(fileOf(name));
    if (!file.remove())
        return Error{phrase("this look cannot be deleted: %1", file.errorString().toStdString()), name, ""};
    return {};
}

}  // namespace pdr::app
