#include "app/presenters/presenter.h"

namespace pdr::app {

void Presenter::showProgressOf(BackgroundJob& job) const {
    ui::StatusLine& status = window().status();
    connect(&job, &BackgroundJob::progressed, &status, &ui::StatusLine::setProgress);
    connect(&job, &BackgroundJob::finished, &status, &ui::StatusLine::endProgress);
}

bool Presenter::cancel(BackgroundJob& job) {
    const bool running = job.isRunning();
    job.cancel();
    return running;
}

}  // namespace pdr::app
