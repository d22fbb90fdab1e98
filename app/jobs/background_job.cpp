#include "app/jobs/background_job.h"

#include <QElapsedTimer>
#include <utility>

#include "render/base/thrown.h"
#include "ui/text/room_text.h"

namespace pdr::app {

BackgroundJob::BackgroundJob() {
    worker_.moveToThread(&thread_);
}

BackgroundJob::~BackgroundJob() {
    stop_.request_stop();
    thread_.quit();
    thread_.wait();
}

void BackgroundJob::cancel() {
    if (!running_)
        return;
    stop_.request_stop();
    running_ = false;
    emit finished();
    emit cancelled();
}

/// Returns the job's Progress, which reports from the job's thread to the caller's thread.
Progress BackgroundJob::progressOf(const std::stop_token& stop) {
    return [this, stop, sinceShown = QElapsedTimer()](double fraction, std::string_view step) mutable {
        constexpr qint64 kEveryMs = 30;  // the eye needs no more, and the window's queue stays short
        if (stop.stop_requested())
            return false;
        if (sinceShown.isValid() && sinceShown.elapsed() < kEveryMs && fraction < 1)
            return true;
        sinceShown.start();
        const QString text = ui::inWords(std::string(step));
        report(stop, [this, fraction, text] { emit progressed(fraction, text); });
        return true;
    };
}

void BackgroundJob::report(const std::stop_token& stop, std::function<void()> event) {
    QMetaObject::invokeMethod(this, [stop, event = std::move(event)] {
        if (!stop.stop_requested())
            event();
    });
}

void BackgroundJob::start(Work work) {
    stop_.request_stop();
    stop_ = std::stop_source();
    running_ = true;
    const std::stop_token stop = stop_.get_token();
    const auto run = [this, stop, work = std::move(work)] {
        const std::function<void()> result = resultOf(work, progressOf(stop), stop);
        QMetaObject::invokeMethod(this, [this, stop, result] { deliver(stop, result); });
    };
    thread_.start();
    if (thread_.isRunning())
        QMetaObject::invokeMethod(&worker_, run);
    else
        deliver(stop, failure({phrase("the system has no thread or no memory left for this"), "",
                               phrase("Close other programs, then try again.")}));
}

/// Runs `work`. All exceptions of the thread are caught here.
std::function<void()> BackgroundJob::resultOf(const Work& work, const Progress& progress, const std::stop_token& stop) {
    try {
        return work(progress, stop);
    } catch (...) {
        return failure(thrownError());
    }
}

std::function<void()> BackgroundJob::failure(const Error& error) {
    return [this, error] { emit failed(error); };
}

/// Calls the result, unless the job was cancelled or replaced by a newer one.
void BackgroundJob::deliver(const std::stop_token& stop, const std::function<void()>& result) {
    if (stop.stop_requested())
        return;
    running_ = false;
    emit finished();
    result();
}

}  // namespace pdr::app
