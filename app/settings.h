#pragma once
/// What the desktop keeps between two runs: the window's geometry and the folder opened last. Nothing of a patient.

#include <QByteArray>
#include <QSettings>
#include <QString>

namespace pdr::app {

class Settings {
  public:
    /// In the user's own configuration, or in `file` if given.
    explicit Settings(const QString& file = {});

    QByteArray windowGeometry() const;
    QByteArray windowState() const;
    void keepWindow(const QByteArray& geometry, const QByteArray& state);
    QString lastFolder() const;
    void keepLastFolder(const QString& folder);

  private:
    mutable QSettings store_;
};

}  // namespace pdr::app
