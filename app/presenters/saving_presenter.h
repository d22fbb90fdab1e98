#pragma once
/// Images that leave the window: saved as they are on the screen, rendered anew for a file, or copied to the clipboard.

#include "app/jobs/image_job.h"
#include "app/presenters/presenter.h"
#include "app/rendering/image_saver.h"
#include "ui/output/image_order.h"

namespace pdr::app {

class SavingPresenter : public Presenter {
    Q_OBJECT

  public:
    explicit SavingPresenter(const Workspace& workspace);

    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void clearImage() override;
    void releaseVolume() override;
    bool cancelJob() override { return cancel(job_); }
    /// Renders an image for a file.
    void render(const ui::ImageOrder& order);
    /// Saves the image on the screen as it is.
    void save(const QString& file, ui::Annotate annotate);
    ImageSaver& saver() { return saver_; }
    ImageJob& job() { return job_; }

  private:
    void connectJob();
    void ask();
    void copy();
    ui::Annotate usualAnnotate() const;
    void showSaved(const QString& file);
    void showWhoCanBeKnown();
    void setImageAvailable(bool available);

    ImageSaver saver_;
    ImageJob job_;
    QString folder_;                     ///< where the last image was saved; kept while the program runs
    QString name_;                       ///< proposed file name of the image on the screen
    std::optional<ui::ImageCost> cost_;  ///< cost of an image like the one on the screen; none: unknown
    bool saidSkin_ = false;              ///< the notice on skin has been shown for this series
};

}  // namespace pdr::app
