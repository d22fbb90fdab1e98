#pragma once
/// Base of the presenters. A presenter makes one feature of the window work: it makes the feature's panel and lets it
/// join the window, turns the user's actions into edits of the document and requests to the renderer, and shows the
/// document, the frames and its own jobs. Desktop holds the list of all presenters and calls them in its order.

#include "app/jobs/background_job.h"
#include "app/presenters/workspace.h"

namespace pdr::app {

class Presenter : public QObject {
    Q_OBJECT

  public:
    /// `workspace` must outlive this object.
    explicit Presenter(const Workspace& workspace) : workspace_(workspace) {}

    /// Shows the document after `changes`. Called once for each operation on the document, and once at the start with
    /// Changes::all.
    virtual void showDocument([[maybe_unused]] Changes changes) {}
    /// Shows a frame; it has an image.
    virtual void showFrame([[maybe_unused]] const std::shared_ptr<const Frame>& frame) {}
    /// Clears what the feature shows of the image: there is none until the next frame.
    virtual void clearImage() {}
    /// Releases the volume and whatever holds it; it is about to be closed, and its memory is waited for.
    virtual void releaseVolume() {}
    /// Cancels the feature's running job. Returns false if none runs.
    virtual bool cancelJob() { return false; }

  protected:
    const Workspace& workspace() const { return workspace_; }
    Document& document() const { return workspace_.document; }
    RenderBridge& bridge() const { return workspace_.bridge; }
    ui::MainWindow& window() const { return workspace_.window; }
    Settings& settings() const { return workspace_.settings; }

    void showError(const Error& error) const { window().message().showError(error); }
    /// Shows the job's progress in the status bar.
    void showProgressOf(BackgroundJob& job) const;
    /// Cancels the job if it runs. Returns whether it did.
    static bool cancel(BackgroundJob& job);

  private:
    Workspace workspace_;
};

}  // namespace pdr::app
