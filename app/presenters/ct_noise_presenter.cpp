#include "app/presenters/ct_noise_presenter.h"

#include "render/volume/value_unit.h"

namespace pdr::app {

CtNoisePresenter::CtNoisePresenter(const Workspace& workspace, ui::LookPanel& panel)
    : Presenter(workspace), panel_(panel) {
    showProgressOf(job_);
    connect(&panel_, &ui::LookPanel::ctDenoisedChosen, &document(), &Document::setCtDenoised);
    connect(&document(), &Document::denoisedCtWanted, this, [this](const std::shared_ptr<const Volume>& scan) {
        afterImage_.call([this, scan] {
            if (document().setup().look.ctDenoised)
                job_.reduce(scan);
        });
    });
    connect(&window(), &ui::MainWindow::cancelRequested, &job_, &CtNoiseJob::cancel);
    connect(&job_, &CtNoiseJob::made, &document(), &Document::takeDenoisedCt);
    connect(&job_, &CtNoiseJob::cancelled, &document(), &Document::keepNoise);
    connect(&job_, &CtNoiseJob::failed, this, [this](const Error& error) {
        document().keepNoise();
        showError(error);
    });
}

void CtNoisePresenter::showDocument(Changes changes) {
    if (!has(changes, Changes::look | Changes::mask | Changes::series))
        return;
    const bool wanted = document().setup().look.ctDenoised;
    panel_.setCtDenoised(wanted, wanted || !document().hasVolume() || unitOf(*document().scan()).isHu);
    if (!wanted)
        job_.cancel();
}

void CtNoisePresenter::showFrame(const std::shared_ptr<const Frame>&) {
    afterImage_.imageStands();
}

void CtNoisePresenter::releaseVolume() {
    afterImage_.reset();
    job_.cancel();
}

}  // namespace pdr::app
