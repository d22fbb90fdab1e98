#pragma once
/// The user's preferences for this machine: language, colours and keys.

#include "app/presenters/presenter.h"

namespace pdr::app {

class PreferencesPresenter : public Presenter {
    Q_OBJECT

  public:
    /// Construct it after all presenters that add panels or menus: their keys are restored here.
    explicit PreferencesPresenter(const Workspace& workspace);
};

}  // namespace pdr::app
