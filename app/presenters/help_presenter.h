#pragma once
/// The manual inside the program.

#include "app/presenters/presenter.h"

namespace pdr::app {

class HelpPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit HelpPresenter(const Workspace& workspace);

  private:
    void showManual();
};

}  // namespace pdr::app
