#pragma once
/// Parts of the scan: opening label maps, finding parts, and how each part is shown.

#include "app/document/part_edits.h"
#include "app/jobs/parts_job.h"
#include "app/presenters/presenter.h"
#include "app/rendering/after_first_image.h"
#include "ui/parts/parts_panel.h"

namespace pdr::app {

class SeriesPresenter;
class SlicesPresenter;

class PartsPresenter : public Presenter {
    Q_OBJECT

  public:
    /// `series` knows what the scan was read from, and `slices` shows the parts in colours; both must outlive this
    /// object.
    PartsPresenter(const Workspace& workspace, const SeriesPresenter& series, SlicesPresenter& slices);

    void showDocument(Changes changes) override;
    void showFrame(const std::shared_ptr<const Frame>& frame) override;
    void releaseVolume() override;
    bool cancelJob() override { return cancel(job_); }
    PartsJob& job() { return job_; }
    ui::PartsPanel& panel() { return *panel_; }
    /// Opens a label map of the scan: a file, or a folder of masks.
    void open(const QString& path, Resampling resampling = Resampling::refused);

  private:
    void connectPanel();
    void connectStyles();
    void connectJob();
    void find(PartRule rule);
    void make(const PartSources& sources);
    void offerResampling(const QString& file, const Error& error);
    void sayLabelsMissing();
    void offerMissing();
    void askForLabels();
    void showLooks();
    void showTint();
    PartsJob::Scan scan() const;

    const SeriesPresenter& series_;
    SlicesPresenter& slices_;
    ui::PartsPanel* panel_;
    PartEdits edits_;
    PartsJob job_;
    AfterFirstImage afterImage_;
    std::vector<int> looks_;  ///< those whose curve a part can have, as places in the document's list
};

}  // namespace pdr::app
