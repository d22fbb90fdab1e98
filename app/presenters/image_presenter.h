#pragma once
/// The image on the screen: its pixels, annotations, error map and marks, and the error under the pointer.

#include "app/presenters/presenter.h"

namespace pdr::app {

class ImagePresenter : public Presenter {
    Q_OBJECT

  public:
    explicit ImagePresenter(const Workspace& workspace);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void clearImage() override;

  private:
    void showErrorAt(QPointF place, const LevelErrorsAt& errors);
};

}  // namespace pdr::app
