#pragma once
/// What the desktop keeps between two runs: the window's geometry, the device, the pace and the target that were
/// chosen, the render nodes and where the certificates lie, and how long pictures took. No secrets, and nothing of a
/// patient, so folders, whose names may be patients', only where that
/// was chosen.

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

class Settings {
  public:
    /// In the user's own configuration, or in `file` if given; either way the owner alone may read it.
    explicit Settings(const QString& file = {});

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    QString device() const;  ///< "auto" as long as none was chosen
    FrameBudget pace() const;
    double target() const;   ///< display levels, [kFinestTarget, kCoarsestTarget]
    bool captioned() const;  ///< unfinished pictures say so
    ui::ThemeChoice theme() const;
    bool remembersFolders() const;      ///< not unless that was chosen: folders are called after patients
    QStringList recentFolders() const;  ///< absolute, the newest first, 8 at most
    /// What the last picture of `kind` took per pixel until it was good for planning [s]; none: there was none.
    std::optional<double> planningSeconds(const QString& kind) const;
    void keepDevice(const QString& name);
    void keepPace(const FrameBudget& pace);
    void keepTarget(double levels);
    void keepCaptioned(bool captioned);
    /// What was remembered is forgotten with the choice not to.
    void keepRemembersFolders(bool remembers);
    /// As the newest, where folders are remembered; started elsewhere, the program finds it again.
    void keepFolder(const QString& folder);
    void forgetFolders();
    QString language() const;  ///< empty: the system's
    void keepLanguage(const QString& code);
    QMap<QString, QString> keys() const;  ///< as ui::KeyBindings::choices() has them
    void keepKeys(const QMap<QString, QString>& keys);
    void keepTheme(ui::ThemeChoice theme);
    QStringList nodes() const;                    ///< "gpu-07:4743", each once
    std::optional<quint16> listenedPort() const;  ///< none: nobody may dial in
    std::optional<Split> nodeSplit() const;       ///< none: as its costs say
    QString certificates() const;                 ///< the folder of this machine's; empty: there are none
    void keepNodes(const QStringList& addresses);
    void keepListenedPort(std::optional<quint16> port);
    void keepNodeSplit(std::optional<Split> split);
    void keepCertificates(const QString& folder);
    void keepPlanningSeconds(const QString& kind, double secondsPerPixel);
    void keepWindow(const QByteArray& geometry, const QByteArray& state);

  private:
    mutable QSettings store_;
};

}  // namespace pdr::app
