#pragma once
/// The settings that the desktop saves between runs: window, device, pace, target, theme, language, keys, render nodes,
/// the folder of certificates, and how long images took. They hold no secrets and nothing of a patient; folders, whose
/// names may be patients' names, are saved only if the user has chosen that.

#include <QByteArray>
#include <QMap>
#include <QSettings>
#include <QString>
#include <optional>

#include "render/accuracy/stop_rule.h"
#include "render/base/split.h"
#include "ui/rendering/render_panel.h"
#include "ui/theme/theme.h"

namespace pdr::app {

/// A plan that was saved or opened, and the folder of its scan: absolute paths.
struct RecentPlan {
    QString file, folder;
    bool operator==(const RecentPlan&) const = default;
};

class Settings {
  public:
    /// Opens the settings in the user's configuration, or in `file` if given. Only the owner may read the file.
    explicit Settings(const QString& file = {});

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    QString device() const;  ///< "auto" until one is chosen
    FrameBudget pace() const;
    double target() const;   ///< display levels, [kFinestTarget, kCoarsestTarget]
    bool captioned() const;  ///< images that leave the window are annotated
    ui::ThemeChoice theme() const;
    bool remembersFolders() const;      ///< false unless chosen: folders may be named after patients
    QStringList recentFolders() const;  ///< absolute paths, the newest first, at most 8
    /// Returns the time per pixel that the last image of `kind` took until it was good for planning [s]; none if there
    /// was none.
    std::optional<double> planningSeconds(const QString& kind) const;
    void keepDevice(const QString& name);
    void keepPace(const FrameBudget& pace);
    void keepTarget(double levels);
    void keepCaptioned(bool captioned);
    /// Saves whether folders are remembered; if not, the remembered ones are forgotten.
    void keepRemembersFolders(bool remembers);
    /// Saves the newest folder, if folders are remembered, as an absolute path that does not depend on the working
    /// directory.
    void keepFolder(const QString& folder);
    /// Returns the plans of remembered folders, the newest first, at most 8.
    QList<RecentPlan> recentPlans() const;
    /// Saves the newest plan, if folders are remembered.
    void keepPlan(const RecentPlan& plan);
    /// Forgets the remembered folders, and the plans with them.
    void forgetFolders();
    QString language() const;  ///< code of the language; empty: the system's
    void keepLanguage(const QString& code);
    QMap<QString, QString> keys() const;  ///< as in ui::KeyBindings::choices()
    void keepKeys(const QMap<QString, QString>& keys);
    void keepTheme(ui::ThemeChoice theme);
    QStringList nodes() const;                    ///< addresses, "gpu-07:4743", each once
    std::optional<quint16> listenedPort() const;  ///< none: no node may dial in
    std::optional<Split> nodeSplit() const;       ///< none: by the costs of the work
    bool nodeChecksAll() const;                   ///< whether all that nodes send is rendered twice
    QString certificates() const;                 ///< folder of this machine's certificates; empty: there are none
    void keepNodes(const QStringList& addresses);
    void keepListenedPort(std::optional<quint16> port);
    void keepNodeSplit(std::optional<Split> split);
    void keepNodeChecksAll(bool all);
    void keepCertificates(const QString& folder);
    void keepPlanningSeconds(const QString& kind, double secondsPerPixel);
    void keepWindow(const QByteArray& geometry, const QByteArray& state);

  private:
    mutable QSettings store_;
};

}  // namespace pdr::app
