#pragma once
/// A file dialog that leaves no trace. Qt saves the places visited by its dialogs in the user's settings, but a
/// folder's name may be a patient's.

#include <QDir>
#include <QFileDialog>
#include <QSettings>
#include <QUrl>
#include <QVariant>
#include <array>

namespace pdr::ui {

/// The places that Qt's dialogs have saved, in this program or another. The destructor restores them.
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

/// Qt's own dialog, since what a desktop's dialog saves cannot be controlled. It writes its settings when it is
/// destroyed: by then it has nothing to save, and the earlier settings are restored after it.
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
