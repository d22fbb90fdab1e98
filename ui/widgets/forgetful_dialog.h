#pragma once
/// A file dialog that leaves no trace. Qt keeps where its dialogs have been in the user's settings, but a folder's name
/// may be a patient's.

#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <QUrl>
#include <QVariant>
#include <array>

namespace pdr::ui {

/// What Qt's dialogs have written about places, by this program or another; written again when it dies.
class KeptPlaces {
  public:
    KeptPlaces() {
        for (std::size_t i = 0; i < kKeys.size(); ++i)
            values_[i] = settings_.value(kKeys[i]);
    }
    ~KeptPlaces() {
        for (std::size_t i = 0; i < kKeys.size(); ++i)
            values_[i].isValid() ? settings_.setValue(kKeys[i], values_[i]) : settings_.remove(kKeys[i]);
    }

  protected:
    static constexpr std::array kKeys{"FileDialog/history", "FileDialog/lastVisited", "FileDialog/shortcuts"};
    std::array<QVariant, kKeys.size()> values_;
    QSettings settings_{QSettings::UserScope, "QtProject"};
};

/// Qt's own dialog, since what a desktop's keeps is out of our hands. It writes its settings when it dies: by then it
/// has nothing to tell, and what was there before comes back after it.
class ForgetfulDialog : KeptPlaces, public QFileDialog {
  public:
    ForgetfulDialog(QWidget* parent, const QString& title) : QFileDialog(parent, title) {
        setOption(QFileDialog::DontUseNativeDialog);
    }
    ~ForgetfulDialog() override {
        setDirectory(QDir::rootPath());
        setHistory({});
        setSidebarUrls({});
    }
};

}  // namespace pdr::ui
