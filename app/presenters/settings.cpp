#include "app/presenters/settings.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <algorithm>
#include <array>
#include <cmath>

#include "render/accuracy/quality.h"
#include "ui/nodes/node_address.h"

namespace pdr::app {
namespace {

constexpr auto kGeometry = "window/geometry";
constexpr auto kState = "window/state";
constexpr auto kDevice = "rendering/device";
constexpr auto kAutomatic = "rendering/automatic";
constexpr auto kIterations = "rendering/iterationsPerImage";
constexpr auto kFrames = "rendering/imagesPerSecond";
constexpr auto kTarget = "rendering/targetLevels";
constexpr auto kCaptioned = "caption";
constexpr auto kTheme = "theme";
constexpr std::array kThemes{"dark", "light", "system"};  ///< in the order of ThemeChoice
constexpr auto kRemembers = "recent/remember";
constexpr auto kFolders = "recent/folders";
constexpr auto kPlans = "recent/plans";
constexpr qsizetype kMostFolders = 8;
constexpr auto kLanguage = "language";
constexpr auto kKeys = "keys";
constexpr auto kNodes = "nodes/addresses";
constexpr qsizetype kMostNodes = 256;
constexpr auto kPort = "nodes/listenedPort";
constexpr auto kSplit = "nodes/split";
constexpr auto kChecksAll = "nodes/checksAll";
constexpr auto kTiles = "tiles";
constexpr auto kSamples = "samples";
constexpr auto kCertificates = "nodes/certificates";
constexpr auto kPlanning = "secondsPerPixelToPlanning/";

QString ownFile() {
    return QSettings(QSettings::IniFormat, QSettings::UserScope, "pd-render", "pdrender").fileName();
}

/// Makes `file` readable and writable by its owner only, and returns its name. QSettings lets everyone read a new file,
/// and does not change the permissions of an existing one.
QString madeTheOwnersAlone(const QString& file) {
    constexpr QFile::Permissions kOwners = QFile::ReadOwner | QFile::WriteOwner;
    QFile kept(file);
    if (QDir().mkpath(QFileInfo(file).path()) && kept.open(QFile::ReadWrite, kOwners))
        kept.setPermissions(kOwners);
    return file;
}

/// Returns the user's own file after restricting it and its folder, which is this program's own, to the owner.
QString ownFileAlone() {
    QString file = madeTheOwnersAlone(ownFile());
    QFile::setPermissions(QFileInfo(file).path(), QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return file;
}

QString absolute(const QString& folder) {
    return QDir::cleanPath(QFileInfo(folder).absoluteFilePath());
}

}  // namespace

Settings::Settings(const QString& file)
    : store_(file.isEmpty() ? ownFileAlone() : madeTheOwnersAlone(file), QSettings::IniFormat) {}

QByteArray Settings::windowGeometry() const {
    return store_.value(kGeometry).toByteArray();
}

QByteArray Settings::windowState() const {
    return store_.value(kState).toByteArray();
}

QString Settings::device() const {
    return store_.value(kDevice, "auto").toString();
}

FrameBudget Settings::pace() const {
    const FrameBudget usual{.automatic = true};
    return {store_.value(kAutomatic, usual.automatic).toBool(), store_.value(kIterations, usual.iterations).toInt(),
            store_.value(kFrames, usual.framesPerSecond).toDouble()};
}

/// Returns kPlanningLevels if the file, which may have been edited, holds no valid target.
double Settings::target() const {
    const double kept = store_.value(kTarget, kPlanningLevels).toDouble();
    return kept >= kFinestTarget && kept <= kCoarsestTarget ? kept : kPlanningLevels;
}

bool Settings::captioned() const {
    return store_.value(kCaptioned, true).toBool();
}

ui::ThemeChoice Settings::theme() const {
    const auto kept = std::ranges::find(kThemes, store_.value(kTheme).toString());
    return kept == kThemes.end() ? ui::ThemeChoice::dark : ui::ThemeChoice(kept - kThemes.begin());
}

bool Settings::remembersFolders() const {
    return store_.value(kRemembers, false).toBool();
}

QStringList Settings::recentFolders() const {
    QStringList folders = store_.value(kFolders).toStringList();
    folders.removeIf([](const QString& folder) { return QDir::isRelativePath(folder); });
    return folders.mid(0, kMostFolders);
}

std::optional<double> Settings::planningSeconds(const QString& kind) const {
    bool known = false;
    const double seconds = store_.value(kPlanning + kind).toDouble(&known);
    return known && seconds > 0 && std::isfinite(seconds) ? std::optional(seconds) : std::nullopt;
}

void Settings::keepDevice(const QString& name) {
    store_.setValue(kDevice, name);
}

void Settings::keepPace(const FrameBudget& pace) {
    store_.setValue(kAutomatic, pace.automatic);
    store_.setValue(kIterations, pace.iterations);
    store_.setValue(kFrames, pace.framesPerSecond);
}

void Settings::keepTarget(double levels) {
    store_.setValue(kTarget, levels);
}

void Settings::keepCaptioned(bool captioned) {
    store_.setValue(kCaptioned, captioned);
}

void Settings::keepRemembersFolders(bool remembers) {
    store_.setValue(kRemembers, remembers);
    if (!remembers)
        forgetFolders();
}

void Settings::keepFolder(const QString& folder) {
    if (!remembersFolders())
        return;
    QStringList folders = recentFolders();
    folders.removeAll(absolute(folder));
    folders.prepend(absolute(folder));
    store_.setValue(kFolders, folders.mid(0, kMostFolders));
}

/// Reads a list in which the file of each plan is followed by its folder.
QList<RecentPlan> Settings::recentPlans() const {
    const QStringList paths = store_.value(kPlans).toStringList();
    QList<RecentPlan> plans;
    for (qsizetype i = 0; i + 1 < paths.size() && plans.size() < kMostFolders; i += 2)
        if (QDir::isAbsolutePath(paths[i]) && QDir::isAbsolutePath(paths[i + 1]))
            plans << RecentPlan{paths[i], paths[i + 1]};
    return plans;
}

void Settings::keepPlan(const RecentPlan& plan) {
    const bool mayBeKept = remembersFolders() && !plan.folder.isEmpty();
    if (!mayBeKept)
        return;
    const RecentPlan newest{absolute(plan.file), absolute(plan.folder)};
    QList<RecentPlan> plans = recentPlans();
    plans.removeIf([&](const RecentPlan& one) { return one.file == newest.file; });
    plans.prepend(newest);
    QStringList paths;
    for (const RecentPlan& one : plans.mid(0, kMostFolders))
        paths << one.file << one.folder;
    store_.setValue(kPlans, paths);
}

void Settings::forgetFolders() {
    store_.remove(kFolders);
    store_.remove(kPlans);
}

QString Settings::language() const {
    return store_.value(kLanguage).toString();
}

void Settings::keepLanguage(const QString& code) {
    store_.setValue(kLanguage, code);
}

QMap<QString, QString> Settings::keys() const {
    QMap<QString, QString> keys;
    store_.beginGroup(kKeys);
    for (const QString& name : store_.childKeys())
        keys[name] = store_.value(name).toString();
    store_.endGroup();
    return keys;
}

void Settings::keepKeys(const QMap<QString, QString>& keys) {
    store_.remove(kKeys);
    for (auto key = keys.begin(); key != keys.end(); ++key)
        store_.setValue(QString(kKeys) + '/' + key.key(), key.value());
}

void Settings::keepTheme(ui::ThemeChoice theme) {
    store_.setValue(kTheme, kThemes[std::size_t(theme)]);
}

/// Leaves out invalid addresses: the file may have been edited.
QStringList Settings::nodes() const {
    QStringList addresses;
    for (const QString& kept : store_.value(kNodes).toStringList().mid(0, kMostNodes))
        addresses << ui::readAddress(kept).address;
    addresses.removeAll({});
    addresses.removeDuplicates();
    return addresses;
}

std::optional<quint16> Settings::listenedPort() const {
    const int kept = store_.value(kPort).toInt();
    return kept >= 1 && kept <= 65535 ? std::optional(quint16(kept)) : std::nullopt;
}

std::optional<Split> Settings::nodeSplit() const {
    const QString kept = store_.value(kSplit).toString();
    return kept == kTiles     ? std::optional(Split::tiles)
           : kept == kSamples ? std::optional(Split::samples)
                              : std::nullopt;
}

bool Settings::nodeChecksAll() const {
    return store_.value(kChecksAll, false).toBool();
}

QString Settings::certificates() const {
    return store_.value(kCertificates).toString();
}

void Settings::keepNodes(const QStringList& addresses) {
    store_.setValue(kNodes, addresses);
}

void Settings::keepListenedPort(std::optional<quint16> port) {
    store_.setValue(kPort, port ? *port : 0);
}

void Settings::keepNodeSplit(std::optional<Split> split) {
    store_.setValue(kSplit, !split ? "" : *split == Split::tiles ? kTiles : kSamples);
}

void Settings::keepNodeChecksAll(bool all) {
    store_.setValue(kChecksAll, all);
}

void Settings::keepCertificates(const QString& folder) {
    store_.setValue(kCertificates, folder);
}

/// Writes the file only if the time has changed by more than 10 %, since each frame's forecast is a little different.
void Settings::keepPlanningSeconds(const QString& kind, double secondsPerPixel) {
    constexpr double kSame = 0.1;
    const std::optional<double> kept = planningSeconds(kind);
    if (!kept || std::fabs(secondsPerPixel - *kept) > kSame * *kept)
        store_.setValue(kPlanning + kind, secondsPerPixel);
}

void Settings::keepWindow(const QByteArray& geometry, const QByteArray& state) {
    store_.setValue(kGeometry, geometry);
    store_.setValue(kState, state);
}

}  // namespace pdr::app
